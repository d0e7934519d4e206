// Slides: drawings as large as they fit, text that is smaller where it is long, and keys that turn the slides.

const slides = [...document.querySelectorAll(".slide")];
const isWithin = ({ firstElementChild: box }) => box.scrollHeight <= box.clientHeight && box.scrollWidth <= box.clientWidth;

/** The largest scale at which the drawing of a slide fits, with its caption below or beside it. */
const largest = (slide, drawing) => {
  const isWhole = () => isWithin(slide) && drawing.scrollHeight <= drawing.clientHeight && drawing.scrollWidth <= drawing.clientWidth;
  let [fits, over] = [0, 4];
  for (let step = 0; step < 9; step += 1) {
    const scale = (fits + over) / 2;
    drawing.style.setProperty("--scale", scale);
    [fits, over] = isWhole() ? [scale, over] : [fits, scale];
  }
  return fits;
};

const fit = () => {
  for (const slide of slides) {
    const drawing = slide.querySelector(".drawing");
    if (drawing === null) {
      for (let size = 44; size > 20 && !isWithin(slide); size -= 1) slide.style.fontSize = `${size}px`;
      continue;
    }
    const layouts = [[false, false], [true, false], ...(drawing.querySelector(".narrow") ? [[false, true], [true, true]] : [])];
    const lay = ([isBeside, isNarrow]) => {
      slide.classList.toggle("beside", isBeside);
      drawing.classList.toggle("phone", isNarrow);
    };
    drawing.classList.add("sizing"); // what is in a drawing takes long to be laid out, and does not change its size
    const scales = layouts.map((layout) => [lay(layout), largest(slide, drawing)][1]);
    const best = scales.indexOf(Math.max(...scales));
    lay(layouts[best]);
    drawing.style.setProperty("--scale", scales[best]);
    drawing.classList.remove("sizing");
  }
};

let now = Math.min(Number(location.hash.slice(1)) || 1, slides.length) - 1;
const turn = (to) => {
  now = Math.max(0, Math.min(to, slides.length - 1));
  slides.forEach((slide, n) => slide.classList.toggle("now", n === now));
  history.replaceState(null, "", `#${now + 1}`);
};
const KEYS = {
  ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, Enter: 1,
  ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Backspace: -1,
  Home: -slides.length, End: slides.length,
};
const enlarge = () => (document.body.style.zoom = Math.min(innerWidth / 1280, innerHeight / 720));

document.fonts.ready.then(() => {
  fit();
  document.body.classList.add("on", "fitted");
  turn(now);
  enlarge();
});
addEventListener("resize", enlarge);
addEventListener("keydown", (event) => {
  if (!(event.key in KEYS) || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  turn(now + KEYS[event.key]);
});
addEventListener("click", ({ clientX }) => turn(now + (clientX < innerWidth / 3 ? -1 : 1)));
