// Live scenes. The library that computes and draws them is a WebAssembly module; this script carries numbers in and
// pictures out, and knows nothing of any one scene.
//
//   1 the module   2 the picture   3 the controls   4 a scene   5 the beginning, and links
//
// The page holds a still of each scene, which stays if anything here fails. A scene wakes when it is nearly on screen
// and sleeps off it: no frame is asked for then. Nothing is remembered here but the values of the controls, the time
// and the view; the module has the whole motion for given settings, so any moment can be drawn at once.
(() => {
"use strict";

// 1 — The module

/** What the library says of settings to which it has no answer, in words for the reader. */
class Trouble extends Error {}

let loaded = Promise.resolve(); // what was asked for before

/** Loads a packed module from below the root of the site: a script that calls `spin`, as `fetch` fails on file://. All call
 *  the same, so one is loaded after another. */
const load = (address) => (loaded = loaded.catch(() => {}).then(() => new Promise((done, fail) => {
  window.spin = done;
  const script = document.createElement("script");
  script.src = path_to_root + address;
  script.onload = () => fail(new Error(`${address} holds no module`)); // unless it has called `spin`
  script.onerror = () => fail(new Error(`${address} cannot be read`));
  document.head.append(script);
})));

const unpack = async (packed) => {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
};

/** Compiled modules, by their addresses. */
const modules = new Map();

const UTF_8 = new TextDecoder();

/** An instance of the module. Numbers go in, texts come out; a length below zero is that of an error. */
class Machine {
  static async at(address) {
    if (!modules.has(address)) modules.set(address, load(address).then(unpack));
    const machine = new Machine();
    machine.run = (await WebAssembly.instantiate(await modules.get(address), {})).exports;
    return machine;
  }
  /** The places of the first numbers of the input. Any call may move the memory, so they are looked up each time. */
  numbers(count) {
    return new Float64Array(this.run.memory.buffer, this.run.input(), count);
  }
  /** The text that a call has left. */
  text(length) {
    const bytes = new Uint8Array(this.run.memory.buffer, this.run.text(), Math.abs(length));
    const text = UTF_8.decode(bytes);
    if (length < 0) throw new Trouble(text);
    return text;
  }
  /** Why it failed, as the program itself said if it gave up. */
  cause(error) {
    return (error instanceof WebAssembly.RuntimeError && this.text(this.run.last_words())) || error.message;
  }
}

const within = (value, least, most) => Math.min(Math.max(value, least), most);
const calm = matchMedia("(prefers-reduced-motion: reduce)");

// 2 — The picture

/** Whether two elements differ in values of attributes alone: of the parts of their lines between quotes, every other. */
const areAlike = (some, other) =>
  some.length === other.length && some.every((part, place) => place % 2 === 1 || part === other[place]);

/** The lines of a text, each of which ends with its own line feed. */
const lines = (text) => text.split("\n").slice(0, -1);

/** An SVG of the page: its still, and the nodes that take its place, one for each line of the module's drawing. */
class Picture {
  #nodes = [];
  #isLive = false;
  /** The lines of what stands behind at every moment, until settings change. */
  behind = null;

  constructor(svg) {
    this.svg = svg;
    this.still = [...svg.childNodes];
    this.words = this.still.filter((node) => ["title", "desc"].includes(node.localName));
    const description = svg.querySelector("desc");
    const ofStill = description?.textContent;
    /** Says what is seen; without words, what the still shows. */
    this.describe = (words = ofStill) => description && (description.textContent = words);
  }
  draw(text) {
    if (!this.#isLive) this.svg.replaceChildren(...this.words, ...this.#nodes.map(({ node }) => node));
    this.#isLive = true;
    const all = [...this.behind, ...lines(text)];
    // Where lines have come or gone, those behind them keep their nodes.
    const more = all.length - this.#nodes.length;
    const isOther = ({ parts }, index) => !(index < all.length && areAlike(parts, all[index].split('"')));
    const stay = more === 0 ? -1 : this.#nodes.findIndex(isOther);
    const from = Math.min(stay < 0 ? Infinity : stay, all.length, this.#nodes.length);
    const gone = this.#nodes.splice(from, Math.max(-more, 0), ...Array(Math.max(more, 0)).fill(null));
    gone.forEach(({ node }) => node.remove());
    all.forEach((line, index) => this.#nodes[index]?.line === line || this.#put(line, index));
  }
  /** Puts a line in its place: if it can, as new values of the attributes of the node that is there. */
  #put(line, index) {
    const [old, parts] = [this.#nodes[index], line.split('"')];
    if (old && areAlike(old.parts, parts)) {
      old.attributes.forEach((attribute, place) => {
        const value = parts[2 * place + 1];
        if (value !== old.parts[2 * place + 1]) attribute.value = value;
      });
      Object.assign(old, { line, parts });
      return;
    }
    const holder = document.createElementNS("http://www.w3.org/2000/svg", "g");
    holder.innerHTML = line;
    const node = holder.firstChild;
    const attributes = [...holder.querySelectorAll("*")].flatMap((element) => [...element.attributes]);
    this.svg.insertBefore(node, (old ?? this.#nodes.slice(index).find(Boolean))?.node ?? null);
    old?.node.remove();
    this.#nodes[index] = { node, line, parts, attributes };
  }
  /** Puts the still back. */
  rest() {
    if (this.#isLive) this.svg.replaceChildren(...this.still);
    this.#isLive = false;
  }
}

// 3 — The controls

/** A number as a reader writes it, with a true minus (and none before a zero) and its unit. */
function written(value, digits, unit = "") {
  const text = value.toFixed(within(digits, 0, 15));
  return text.replace("-", Number(text) === 0 ? "" : "−") + (/^°?$/.test(unit) ? "" : "\u00a0") + unit;
}

const texts = (node) => (node instanceof Text ? node : [...node.childNodes].flatMap(texts));
/** Writes a number, which may be a power of ten, into an element; where the tags are as before, only the letters change. */
function write(element, html) {
  const [found, parts, tags] = [texts(element), html.split(/<.*?>/).filter(Boolean), html.match(/<.*?>/g)?.join()];
  if (element.tags !== tags || found.length !== parts.length || html.includes("&")) element.innerHTML = html;
  else found.forEach((text, index) => (text.data = parts[index]));
  element.tags = tags;
}

/** A control: its name, its value at the start and now, and the elements that change it. */
function control(name, elements) {
  const [first] = elements;
  const { type, step, dataset, defaultValue } = first;
  const isLog = "log" in dataset; // a slider over powers of ten, with values of three digits
  const output = first.parentElement.querySelector("output");
  let pressed = Number(dataset.start); // the time at which a button was pressed last
  const [get, set] = {
    range: [
      () => (isLog ? Number((10 ** first.valueAsNumber).toPrecision(3)) : first.valueAsNumber),
      (value) => (first.value = isLog ? within(Math.log10(Math.max(value, 0)), +first.min, +first.max) : value),
    ],
    radio: [
      () => elements.findIndex((radio) => radio.checked),
      (place) => elements[place] && (elements[place].checked = true),
    ],
    checkbox: [() => Number(first.checked), (isOn) => (first.checked = isOn !== 0)],
    button: [() => pressed, (time) => (pressed = Math.max(time, -1))],
    hidden: [() => Number(first.value), (angle) => (first.value = angle)],
  }[type];
  const shown = (value) => {
    const digits = isLog ? 2 - Math.floor(Math.log10(value)) : (step.split(".")[1] ?? "").length;
    return written(value, digits, dataset.unit ?? "°");
  };
  const show = () => {
    if (type !== "range") return;
    const text = shown(get());
    if (output) output.textContent = text;
    first.setAttribute("aria-valuetext", text);
  };
  // A page that is loaded again begins anew, whatever the browser remembers.
  for (const radio of elements) if ("defaultChecked" in radio) radio.checked = radio.defaultChecked;
  if (type === "range") first.value = defaultValue;
  show();
  // There an arrow key changes the second digit, so round values are met.
  if (isLog) first.addEventListener("keydown", (event) => {
    const way = /^Arrow(Right|Up)$/.test(event.key) - /^Arrow(Left|Down)$/.test(event.key);
    if (way === 0) return;
    event.preventDefault();
    const digit = 10 ** (Math.floor(Math.log10(get() * (way > 0 ? 1 : 0.999))) - 1);
    set((Math.round(get() / digit) + way) * digit);
    first.dispatchEvent(new Event("input"));
  });
  const words = (first.closest("fieldset")?.querySelector("legend") ?? first.labels?.[0] ?? first).textContent.trim();
  const own = { name, elements, words, show, shown, isButton: type === "button", isKept: type === "hidden", start: get() };
  // A button whose presses add up: the controls that say how strong one is, and the presses before the last.
  Object.assign(own, { strengths: dataset.adds?.split(" ").filter(Boolean), earlier: [] });
  return Object.defineProperty(own, "value", { get, set: (value) => [set(value), show()] });
}

/** The controls below a selector, in the order in which the module takes their values. */
function controlsIn(figure, selector) {
  const groups = new Map();
  for (const element of figure.querySelectorAll(`${selector} :is([name], [data-name])`)) {
    const name = element.dataset.name ?? element.name;
    groups.set(name, [...(groups.get(name) ?? []), element]);
  }
  return [...groups].map(([name, elements]) => control(name, elements));
}

/** The value that settings give to a control; its start, if they name none that is a number. */
function named(settings, { name, start }) {
  const last = settings.getAll(name).at(-1);
  const value = last ? Number(last) : NaN;
  return Number.isFinite(value) ? value : start;
}

/** As many presses add up. */
const MOST_PRESSES = 20;
const NOTHING = -1; // in a hand

/** The presses of a button before the last that settings name: times, and how strong each was. */
function pressesIn(settings, { name, strengths }) {
  if (!strengths) return [];
  const presses = settings.getAll(name).slice(0, -1).map((press) => press.split(",").map(Number));
  const isPress = (press) => press.length === 1 + strengths.length && press.every(Number.isFinite) && press[0] >= 0;
  return presses.filter(isPress).slice(-MOST_PRESSES);
}

/** How fast time goes, in words. */
function paced(pace) {
  const times = (ratio) => `${ratio < 9.5 ? Number(ratio.toPrecision(2)) : Math.round(ratio)} times`;
  if (Math.abs(pace - 1) < 0.03) return "as it is";
  return pace < 1 ? `slowed ${times(1 / pace)}` : `${times(pace)} as fast`;
}

const NONE = new URLSearchParams();

/** What settings keep of some controls to compare, a value and presses for each; nothing if they do not say so. */
function keptIn(settings, controls) {
  if (!Number(settings.get("kept"))) return null;
  const own = new URLSearchParams([...settings].flatMap(([name, value]) => (name.startsWith("kept.") ? [[name.slice(5), value]] : [])));
  return controls.map((control) => {
    const asked = own.has(control.name) ? own : settings;
    return { value: named(asked, control), earlier: pressesIn(asked, control) };
  });
}

/** The tone of a scene: made when a reader asks for it, and silent but while the scene plays. */
class Tone {
  #context = new AudioContext();
  #loudness = this.#context.createGain();
  #source = this.#context.createOscillator();

  constructor() {
    // Overtones, so that a few strokes a second are heard as strokes, and on small loudspeakers too, which give nothing
    // below some 200 Hz.
    const parts = Float32Array.from({ length: 48 }, (_, n) => (n > 0 ? 1 / Math.sqrt(n) : 0));
    this.#source.setPeriodicWave(this.#context.createPeriodicWave(parts, parts.map(() => 0)));
    this.#loudness.gain.value = 0;
    this.#source.connect(this.#loudness).connect(this.#context.destination);
    this.#source.start();
  }
  /** Sounds from now on so, Hz and a loudness from 0 to 1. */
  set(frequency, loudness) {
    const now = this.#context.currentTime;
    if (frequency > 0) this.#source.frequency.setTargetAtTime(frequency, now, 0.02);
    this.#loudness.gain.setTargetAtTime(MOST_LOUD * within(loudness, 0, 1), now, 0.03);
  }
  end() {
    this.#context.close();
  }
}
const MOST_LOUD = 0.5;

// 4 — A scene

class Scene {
  #frame = 0; // that is asked for
  #before = null; // when the frame before was drawn, if it plays
  #isChanged = true; // since the module computed the motion
  #isNew = true; // the motion does not go on from the one before
  #isAtStill = true; // at the moment of the still: it plays from the beginning
  #usual = null; // how long the motion runs with the settings of the start
  #isOnScreen = false;
  #isWoken = false;
  #shown = []; // readings
  #read = 0; // when they were
  /** What is kept to compare, a value and presses for each control. */
  kept = null;
  /** Puts the picture back that stands beside a link. */
  unpeek = null;
  #tone = null;
  isPlaying = false;
  hasFailed = false;

  constructor(figure) {
    const find = (selector) => figure.querySelector(selector);
    this.figure = figure;
    this.pictures = [...figure.querySelectorAll(".drawing > svg")].map((svg) => new Picture(svg));
    this.controls = controlsIn(figure, ".controls");
    this.view = controlsIn(figure, ".view");
    this.angles = this.view.map(({ start }) => start);
    [this.drawing, this.play, this.step, this.time, this.clock, this.speed, this.says, this.copied, this.sound, this.keptAs] =
      [".drawing", ".play", ".step", ".time", ".clock", ".pace", ".says", ".copied", ".sound", ".kept"].map(find);
    this.waiting = [...figure.querySelectorAll("[data-when]")].map((element) => {
      const [name, from, to] = element.dataset.when.split(" ");
      const other = this.controls.find((control) => control.name === name);
      const parts = element.querySelectorAll("input");
      return () => parts.forEach((part) => (part.disabled = !(other.value >= Number(from) && other.value <= Number(to))));
    });
    this.presets = [...figure.querySelectorAll(".presets button")]
      .map((button) => ({ button, settings: new URLSearchParams(button.dataset.set) }));
    this.readings = [...figure.querySelectorAll(".readings dd")].map((place) => place.appendChild(document.createElement("span")));
    // A formula in a label is a part of its name, which no browser hears by itself.
    for (const math of figure.querySelectorAll(".panel math")) math.ariaLabel = math.textContent;
    // Sliders say their values themselves; a clock that was read aloud would never stop.
    for (const output of figure.querySelectorAll("output")) output.ariaLive = "off";
    // A span of one text, which has its room: as the text changes, nothing else is laid out or looked up in style sheets.
    this.clock = this.clock.appendChild(document.createElement("span")).appendChild(new Text());
    this.still = Number(this.time.defaultValue);
    [this.now, this.duration, this.pace] = [this.still, Infinity, 1];
    this.#lock(true);
    this.#cover();
    this.says.textContent = "The program that moves this picture is loading.";
  }
  #lock(isLocked) {
    for (const part of this.figure.querySelectorAll(".presets, .panel > :not(.words)")) part.inert = isLocked;
  }
  /** Below a guess what answers it is covered until the reader has made it, opened its fold, or asks for it here. */
  #cover() {
    const folds = [];
    for (let node = this.figure; (node = node.previousElementSibling) && !/^H[12]$/.test(node.nodeName); ) {
      if (node.matches("ol + details")) folds.push(node);
    }
    if (folds.length === 0) return;
    const cover = this.says.parentElement.appendChild(document.createElement("button"));
    Object.assign(cover, { type: "button", className: "cover", textContent: "Show what happens" });
    this.uncover = () => this.figure.classList.remove("covered");
    this.figure.classList.add("covered");
    this.on([cover], "click", () => this.uncover());
    this.on(folds, "toggle", () => this.uncover()); // an answer that is chosen opens its fold
  }
  uncover() {}

  /** Loads the library, draws the first moment and begins to listen; once. */
  async wake() {
    if (this.#isWoken) return;
    this.#isWoken = true;
    try {
      this.machine = await Machine.at(this.figure.dataset.module);
      this.#show();
    } catch (error) {
      this.fail(error);
    }
    if (this.hasFailed) return;
    this.figure.classList.add("awake");
    this.#lock(false);
    this.#listen();
    this.follow();
  }

  /** Gives the still back, for good. */
  fail(error) {
    this.hasFailed = true;
    this.isPlaying = false;
    this.#hush();
    this.unpeek?.();
    cancelAnimationFrame(this.#frame);
    console.warn(`${this.figure.id}: ${this.machine?.cause(error) ?? error.message}`);
    for (const picture of this.pictures) picture.rest();
    this.figure.classList.remove("awake");
    this.figure.classList.add("failed");
    this.#say("This picture cannot move here: its program did not run. The text does not need it.", true);
  }

  /** Computes the motion for the present settings. */
  #begin() {
    const { run } = this.machine;
    for (const { button, settings } of this.presets) button.ariaPressed = this.#isSet(settings);
    for (const wait of this.waiting) wait();
    this.#nameKept();
    const presses = (whose, all) => all.flatMap(({ earlier }, place) =>
      earlier.flatMap(([time, one = 0, other = 0]) => [whose, place, time, one, other]));
    const kept = this.kept ?? [];
    const ofKept = kept.flatMap(({ value }, place) => (value === this.controls[place].value ? [] : [1, place, value, 0, 0]));
    const values = [...this.controls.map(({ value }) => value), ...presses(0, this.controls), ...ofKept, ...presses(2, kept)];
    this.machine.numbers(values.length).set(values);
    this.machine.text(run.start(Number(this.figure.dataset.scene), values.length, this.#isNew ? -1 : this.now));
    const reached = this.machine.numbers(this.controls.length);
    this.controls.forEach((control, place) => control.isKept && (control.value = reached[place]));
    [this.#isChanged, this.#isNew] = [false, false];
    for (const picture of this.pictures) picture.behind = null;
    [this.duration, this.pace, this.repeats] = [run.duration(), run.pace(), run.repeats() !== 0];
    this.#usual ??= this.duration;
    this.time.max = this.duration;
    this.digits = Math.ceil(0.7 - Math.log10(this.pace)); // of the clock: one can see them change
    this.clock.parentNode.style.minWidth = `${written(this.duration, this.digits, "s").length}ch`;
    for (const option of this.speed.options) {
      const words = paced(this.pace * option.value);
      if (option.text !== words) option.text = words;
    }
  }

  /** Draws the present moment, in the picture for the page or for the phone, and writes what is beside it. */
  #draw(moment) {
    const { machine, now, pictures } = this;
    const picture = (this.picture ??= pictures.find(({ svg }) => svg.getClientRects().length > 0) ?? pictures[0]);
    const [azimuth = 0, elevation = 0] = this.angles.map((angle) => (angle * Math.PI) / 180);
    const isNarrow = picture.svg.matches(".narrow");
    picture.behind ??= lines(machine.text(machine.run.behind(isNarrow)));
    picture.draw(machine.text(machine.run.draw(now, azimuth, elevation, isNarrow)));
    this.#sing();
    // Nobody reads numbers that change faster; and each time one does the panel is laid out.
    if (this.isPlaying && moment - this.#read < 100) return;
    this.#read = moment;
    this.time.value = now;
    this.clock.data = written(now, this.digits, "s");
    const values = machine.text(machine.run.readings(now)).split("\n");
    this.readings.forEach((place, index) => {
      if (this.#shown[index] === values[index]) return;
      write(place, values[index]);
      const ofText = `${place.textContent.length + 2}ch`;
      if (parseFloat(place.style.inlineSize || 0) < parseFloat(ofText)) place.style.inlineSize = ofText;
    });
    this.#shown = values;
    // Under a reader's hand the time does not speak by itself.
    if (!this.isPlaying || document.activeElement !== this.time) this.time.ariaValueText = this.clock.data;
  }

  /** Asks for one frame. */
  ask() {
    if (this.machine && !this.hasFailed) this.#frame ||= requestAnimationFrame((moment) => this.#show(moment));
  }

  /** A frame: takes in what the reader has changed, lets time pass, draws, and asks for the next if it plays. */
  #show(moment) {
    this.#frame = 0;
    try {
      this.drag?.();
      const hasChanged = this.#isChanged;
      if (hasChanged) this.#begin();
      const isCalm = hasChanged && this.#isAtStill && !this.isPlaying;
      if (isCalm) this.now = this.duration === this.#usual ? this.still : this.duration / 2;
      if (this.isPlaying) this.#advance(moment);
      this.now = within(this.now, 0, this.duration);
      this.#draw(moment);
      const isStale = hasChanged || !this.isPlaying || this.says.classList.contains("trouble");
      if (isStale) this.#say(this.machine.text(this.machine.run.words(this.now)), false);
      this.#name();
    } catch (error) {
      if (error instanceof Trouble) this.#say(error.message, true); // and the last picture stays
      else this.fail(error);
    }
    if (this.isPlaying && this.#isOnScreen && !this.#isChanged) this.ask();
  }
  #advance(moment) {
    if (!this.isHeld) this.now += (within(moment - (this.#before ?? moment), 0, 100) / 1000) * this.pace * this.speed.value;
    this.#before = moment;
    if (this.now < this.duration) return;
    if (this.repeats) this.now %= this.duration;
    else this.#setPlaying(false);
  }
  /** Whether the controls stand so; what is kept counts if the settings name it, and if they are those of the start. */
  #isSet(settings) {
    const isNear = (one, other) => Math.abs(one - other) < 1e-6;
    const counts = settings === NONE || settings.has("kept");
    const kept = keptIn(settings, this.controls);
    return this.controls.every((control, place) => {
      if (control.isKept || (control.name === "kept" && !counts)) return true;
      const isAs = isNear(control.value, named(settings, control)) && control.earlier.length === 0;
      return isAs && (!counts || isNear(this.kept?.[place].value ?? 0, kept?.[place].value ?? 0));
    });
  }
  /** Says of what is kept in what it differs. */
  #nameKept() {
    if (!this.keptAs) return;
    const name = (control, value) => {
      const { elements: [first], words, shown } = control;
      if (first.type === "radio") return control.elements[value].labels[0].textContent.trim();
      if (control.isButton) return `${words} ${value < 0 ? "never" : written(value, 2, "s")}`;
      return `${words} ${first.type === "checkbox" ? (value ? "on" : "off") : shown(value)}`;
    };
    const others = (this.kept ?? []).flatMap(({ value }, place) => {
      const control = this.controls[place];
      return control.isKept || control.name === "kept" || value === control.value ? [] : [name(control, value)];
    });
    this.keptAs.textContent = this.kept ? `pale: ${others.join(", ") || "the same so far"}` : "";
  }
  /** What is heard now: nothing unless it was asked for, and plays in sight. */
  #sing() {
    if (!this.#tone) return;
    const count = this.isPlaying && this.#isOnScreen && !document.hidden ? this.machine.run.sound(this.now) : 0;
    const [frequency = 0, loudness = 0] = this.machine.numbers(count);
    this.sound.dataset.hertz = frequency;
    this.#tone.set(frequency, loudness);
  }
  #hush() {
    this.#tone?.end();
    this.#tone = null;
    this.sound?.setAttribute("aria-pressed", "false");
  }
  /** What is read aloud to those who cannot see: nothing while it stays the same. */
  #say(words, isTrouble) {
    if (this.says.textContent !== words) this.says.textContent = words;
    const isOther = !isTrouble && !this.#isSet(NONE);
    for (const picture of this.pictures) picture.describe(isOther ? words : undefined);
    this.says.classList.toggle("trouble", isTrouble);
    this.figure.classList.toggle("pale", isTrouble && !this.hasFailed);
    for (const part of [this.play, this.step, this.time, this.speed]) part.disabled = isTrouble; // there is no motion
    this.#name();
  }
  /** Says what the button would do. */
  #name() {
    const isMoving = this.isPlaying && !this.play.disabled;
    const name = isMoving ? "Pause" : this.#isAtEnd() ? "Again" : "Play";
    if (this.play.textContent !== name) this.play.textContent = name; // as it is called at each frame
  }
  #isAtEnd() {
    return this.now >= this.duration * (1 - 1e-9); // a slider rounds
  }

  /** Settings have changed; they take effect in the next frame, however often they change until then. */
  change() {
    this.#isChanged = true;
    this.ask();
  }
  /** Plays on; from the beginning if it stands at its end, or still at the moment of the still. */
  start() {
    if (this.#isAtStill || this.#isAtEnd()) this.now = 0;
    this.#setPlaying(true);
  }
  #setPlaying(isPlaying) {
    if (isPlaying) markFar();
    this.#isAtStill = false;
    this.isPlaying = isPlaying;
    this.#before = null;
    this.#name();
    this.#sing();
    this.ask();
  }
  /** Goes to a moment, and stays there. */
  seek(time) {
    this.now = time;
    this.#setPlaying(false);
  }
  /** A button of the scene is pressed now, and the motion goes on from there. */
  press(button) {
    const now = +this.now.toPrecision(6); // as its link gives it: what is drawn by lot is the same there
    this.#addUp(button, now);
    button.value = now;
    this.#setPlaying(true);
    this.change();
  }
  /** Before a button is pressed now: where presses add up, the last becomes one of those until now. */
  #addUp(button, now) {
    if (!button.strengths || button.value < 0) return;
    const strengths = button.strengths.map((name) => this.controls.find((control) => control.name === name).value);
    const all = [...button.earlier, [button.value, ...strengths]];
    button.earlier = all.filter(([time]) => time <= now).slice(-MOST_PRESSES);
  }
  /** Sets controls by name, the others to their starts, but for what is kept if it `stays`; begins anew without a time. */
  set(settings, stays = false) {
    if (!stays || settings.has("kept")) this.kept = keptIn(settings, this.controls);
    for (const control of this.controls) {
      Object.assign(control, { value: named(settings, control), earlier: pressesIn(settings, control) });
      if (control.name === "kept") control.value = Number(this.kept !== null);
    }
    this.#isNew = true;
    this.change();
    this.#isAtStill = true;
    const time = named(settings, { name: "t" });
    if (time !== undefined) this.seek(time);
    else if (!calm.matches || this.isPlaying) this.start();
  }
  /** Changes the angles of the view, in degrees. */
  look(to) {
    this.angles = this.view.map((control, index) => {
      control.value = to(this.angles[index], control);
      return control.value;
    });
    this.ask();
  }
  /** The address of the present settings, time and view. */
  address() {
    const changed = [...this.controls, ...this.view].filter(({ value, start, earlier }) => value !== start || earlier?.length);
    const kept = (this.kept ?? []).map((own, place) => ({ ...own, name: `kept.${this.controls[place].name}` }));
    const written = ({ name, value, earlier = [] }) =>
      [...earlier, [value]].map((numbers) => `${name}=${numbers.map((number) => +number.toPrecision(6))}`).join("&");
    const isOther = (own, place) => written(own) !== `kept.${written(this.controls[place])}`;
    const settings = [...changed, ...kept.filter(isOther), { name: "t", value: this.now }];
    return `#${this.figure.id}?${settings.map(written).join("&")}`;
  }
  /** Does what the page's address says, if it is of this scene. */
  follow() {
    const target = addressed(location.hash);
    if (target?.figure !== this.figure || !this.machine || this.hasFailed) return;
    const { settings } = target;
    this.uncover();
    this.look((_, control) => named(settings, control));
    this.set(settings);
  }

  /** Shows the picture beside a link of the text that was followed from afar, so that the reader stays there, until it
   *  is closed or the reader comes to the scene. Whether it does. */
  peek(link) {
    const { figure, drawing } = this;
    if (this.hasFailed || !drawing.showPopover) return false;
    this.wake();
    figure.style.minHeight = getComputedStyle(figure).height; // nothing moves where it was
    const bar = document.createElement("p");
    bar.className = "peek";
    const watch = new IntersectionObserver((entries) => entries.at(-1).isIntersecting && this.unpeek());
    const escape = ({ key }) => key === "Escape" && this.unpeek();
    this.unpeek = () => {
      this.unpeek = null;
      watch.disconnect();
      removeEventListener("keydown", escape);
      bar.remove();
      drawing.popover = null;
      figure.style.minHeight = "";
    };
    const button = (words, act) => {
      const button = document.createElement("button");
      Object.assign(button, { type: "button", textContent: words });
      this.on([button], "click", act);
      return button;
    };
    const close = button("Close", () => this.unpeek());
    bar.append(button("Go to the scene", () => this.visit()), close);
    drawing.prepend(bar);
    drawing.popover = "manual";
    drawing.classList.toggle("above", link.getBoundingClientRect().top > innerHeight / 2);
    drawing.showPopover();
    addEventListener("keydown", escape);
    watch.observe(figure.querySelector(".panel"));
    return true;
  }
  /** Goes to the scene: the eye, and with it the place from which the Tab key goes on. */
  visit() {
    this.unpeek?.();
    this.figure.tabIndex = -1;
    this.figure.focus({ preventScroll: true });
    if (this.#isFar()) this.figure.scrollIntoView(); // else the link stays in sight too
  }
  #isFar() {
    const { top, bottom } = this.drawing.getBoundingClientRect();
    return top < -1 || bottom > innerHeight + 1;
  }
  /** Comes into sight for who follows a link to it, from the text or from elsewhere; again, if it is there already. */
  come(link, isAgain) {
    const stays = link && (this.unpeek ? !isAgain : this.#isFar() && this.peek(link));
    if (!stays) this.visit();
  }

  /** Keeps the present motion to compare, or lets it go. */
  #keep(isKept) {
    const snapshot = ({ name, value, earlier }) => ({ value: name === "kept" ? 1 : value, earlier: [...earlier] });
    this.kept = isKept ? this.controls.map(snapshot) : null;
    this.change();
  }

  /** Puts a link into the page's address and, if it can, on the clipboard. */
  #copy(event) {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return; // it is opened elsewhere
    event.preventDefault();
    const link = event.currentTarget;
    history.replaceState({ isVisited: true }, "", link.href);
    const say = (words) => (this.copied.textContent = words);
    const copying = navigator.clipboard?.writeText(link.href) ?? Promise.reject();
    copying.then(() => say("copied"), () => say("it is the page's address now"));
    setTimeout(say, 4000, "");
  }

  /** Does something at events of elements. What goes wrong then is the end of the scene, and not of the page. */
  on(elements, events, act) {
    const guarded = (event) => {
      try {
        if (!this.hasFailed) act(event);
      } catch (error) {
        this.fail(error);
      }
    };
    for (const element of elements) {
      for (const name of events.split(" ")) element.addEventListener(name, guarded, { passive: false });
    }
  }
  #listen() {
    const on = (selector, events, act) => this.on(this.figure.querySelectorAll(selector), events, act);
    on(".play", "click", () => (this.isPlaying ? this.#setPlaying(false) : this.start()));
    const step = (way) => this.seek(this.now + (way * this.pace * this.speed.value) / 10);
    on(".step", "click", () => step(1));
    on(".sound", "click", () => {
      if (this.#tone) this.#hush();
      else {
        this.#tone = new Tone();
        this.sound.setAttribute("aria-pressed", "true");
        this.#sing();
      }
    });
    this.on([document], "visibilitychange", () => this.#sing());
    on(".time", "input", () => this.seek(this.time.valueAsNumber));
    on(".view input", "input", () => this.look((_, { value }) => value));
    on(".reset", "click", () => {
      this.look((_, { start }) => start);
      this.set(NONE);
    });
    for (const { button, settings } of this.presets) this.on([button], "click", () => this.set(settings, true));
    // Before the link is opened elsewhere, or copied by the browser.
    on(".share a", "pointerdown focus keydown", ({ currentTarget }) => (currentTarget.href = this.address()));
    on(".share a", "click", (event) => this.#copy(event));
    for (const control of this.controls) {
      if (control.isButton) this.on(control.elements, "click", () => this.press(control));
      else if (control.name === "kept") this.on(control.elements, "input", () => this.#keep(control.value !== 0));
      else this.on(control.elements, "input", () => this.change(control.show()));
    }
    // The arrow keys belong to the slider that has them, and else to the time; not to the book, whose pages they would turn.
    this.on([this.figure], "keydown", (event) => {
      const { key, target, altKey, ctrlKey, metaKey } = event;
      if (key === "Escape" && this.isPlaying) this.#setPlaying(false);
      if (altKey || ctrlKey || metaKey || !/^(Arrow|Home|End|Page)/.test(key)) return;
      event.stopPropagation();
      const way = (key === "ArrowRight") - (key === "ArrowLeft");
      if (way === 0 || target.matches("input, select")) return;
      event.preventDefault();
      if (!this.play.disabled) step(way);
    });
    for (const { svg } of this.pictures) this.#give(svg);
    new ResizeObserver(() => {
      this.picture = null; // the page may have come to be narrow
      this.ask();
    }).observe(this.drawing);
    let isNew = true;
    new IntersectionObserver((entries) => {
      const { isIntersecting, intersectionRatio, intersectionRect } = entries.at(-1); // the newest of a batch
      this.#isOnScreen = isIntersecting;
      this.#before = null;
      this.#sing();
      if (isNew && (intersectionRatio >= 0.5 || intersectionRect.height >= innerHeight / 2)) {
        isNew = false;
        if (!calm.matches && this.#isAtStill) this.start();
      }
      if (this.isPlaying && isIntersecting) this.ask();
    }, { threshold: [0, 0.5] }).observe(this.drawing);
    // Paper has the still.
    this.on([window], "beforeprint", () => this.pictures.forEach((picture) => picture.rest()));
    this.on([window], "afterprint", () => this.ask());
  }

  /** Gives a picture into the hands of the reader, who draw its grips and turn the view. */
  #give(svg) {
    const { machine, view, drawing } = this;
    let held = null; // a grip, or the view
    const place = ({ clientX, clientY }) =>
      new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());
    const gripAt = (event) => {
      const { x, y } = place(event);
      return machine.run.grip(x, y, (event.pointerType === "mouse" ? 12 : 24) / svg.getScreenCTM().a);
    };
    svg.style.touchAction = view.length > 0 ? "pan-y pinch-zoom" : ""; // up and down a finger moves the page,
    // but on a grip the grip.
    this.on([svg], "touchstart", (event) => gripAt(event.touches[0]) !== NOTHING && event.preventDefault());
    this.on([svg], "mousedown", (event) => held && event.preventDefault()); // words are not selected
    this.on([svg], "pointerdown", (event) => {
      const grip = gripAt(event);
      if (!event.isPrimary || event.button !== 0 || (grip === NOTHING && view.length === 0)) return;
      this.isHeld = grip < NOTHING; // time stands still while a hand holds a body
      held = { grip, at: place(event), angles: this.angles, degrees: 180 / svg.viewBox.baseVal.width };
      svg.setPointerCapture(event.pointerId);
      drawing.style.cursor = "grabbing";
    });
    this.on([svg], "pointermove", (event) => {
      if (!held) {
        const isGrip = event.pointerType === "mouse" && gripAt(event) !== NOTHING;
        drawing.style.cursor = isGrip ? "move" : view.length > 0 ? "grab" : "";
        return;
      }
      const [{ grip, at, angles, degrees }, { x, y }] = [held, place(event)];
      this.drag = () => { // in the next frame
        this.drag = null;
        const azimuth = angles[0] - (x - at.x) * degrees;
        const elevation = angles[1] + (y - at.y) * degrees; // up to the ends of its slider: not over the top
        const turned = { azimuth: azimuth - 360 * Math.floor((azimuth + 180) / 360), elevation };
        if (grip === NOTHING) return this.look((_, { name }) => turned[name]);
        const values = [...machine.numbers(machine.run.drag(grip, x, y))];
        if (values.length === 0) return undefined;
        this.controls.forEach((control, index) => {
          if (!control.strengths || control.value === values[index] || values[index] !== this.now) return;
          this.#addUp(control, this.now);
          this.#setPlaying(true); // from here, as soon as it is let go
        });
        this.controls.forEach((control, index) => (control.value = values[index]));
        return this.change();
      };
      this.ask();
    });
    this.on([svg], "pointerup pointercancel", () => ([held, drawing.style.cursor, this.isHeld] = [null, "", false]));
  }
}

// 5 — The beginning, and links

/** The figure and the settings in an address like `#scene-turning?spin=3&t=1.2`. */
function addressed(hash) {
  const [, id, settings] = /^#(scene-[\w-]+)\?(.*)$/.exec(hash) ?? [];
  const figure = id && document.getElementById(id);
  return figure && { figure, settings: new URLSearchParams(settings) };
}

/** Does something when an element is nearly on screen. */
function whenNear(element, act) {
  const watch = new IntersectionObserver((entries) => {
    if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
    watch.disconnect();
    act();
  }, { rootMargin: "100% 0px" });
  watch.observe(element);
}

/** Marks the parts of the page that are farther from the screen than its height, again whenever it has been scrolled by half
 *  of that: for each picture that changes Chromium goes through the whole page, and its formulas take longer than the
 *  picture. Far parts are spared that (`live.css`). Not scenes; nor code with its answers, whose margins reach out of it. A page
 *  that nobody has touched stays whole, so that a program that takes its picture gets all of it. */
function markFar() {
  if (!isTouched) return;
  if (Math.abs(scrollY - markedAt) < innerHeight / 2) return; // they would be nearly the same
  if (markedAt === -Infinity) addEventListener("scroll", markFar, { passive: true });
  markedAt = scrollY;
  const parts = [...document.querySelectorAll("main > :not(.scene, .answering, :has(.scene))")];
  if (parts.length > 999) return; // all pages in one: marked at once they hold Chromium up for a minute
  const boxes = parts.map((part) => part.getBoundingClientRect());
  const isFar = ({ top, bottom }) => bottom < -innerHeight || top > 2 * innerHeight;
  parts.forEach((part, index) => part.classList.toggle("far", isFar(boxes[index])));
}
let markedAt = -Infinity;
let isTouched = false;
for (const kind of ["pointermove", "pointerdown", "keydown", "wheel"]) addEventListener(kind, () => {
  isTouched = true;
  if (scenes.some(({ isPlaying }) => isPlaying)) markFar();
}, { once: true, passive: true });

const scenes = [...document.querySelectorAll("figure.scene[data-module]")].map((figure) => new Scene(figure));
for (const scene of scenes) whenNear(scene.figure, () => scene.wake());

/** The link of the text that is being followed. */
let followed = null;

/** Has the scene that the page's address names come into sight. Coming back to an address is left to the browser. */
function visit(isAgain = false) {
  const target = addressed(location.hash);
  if (!target) return;
  if (isAgain || !history.state?.isVisited) {
    history.replaceState({ isVisited: true }, "");
    scenes.find(({ figure }) => figure === target.figure)?.come(followed, isAgain);
  }
  followed = null;
  for (const scene of scenes) scene.follow();
}
// Without a script a link of the text leads to the still; with it, to its setting.
for (const link of document.querySelectorAll("a[data-set]")) link.hash += `?${link.dataset.set}`;
visit();
window.spinning = { Machine, whenNear }; // for snippets whose numbers can be changed
addEventListener("hashchange", () => visit());
// A link that is followed again changes no address.
document.addEventListener("click", ({ target, defaultPrevented, ctrlKey, metaKey, shiftKey }) => {
  const link = target.closest?.("a[href]");
  if (!link || defaultPrevented || ctrlKey || metaKey || shiftKey || !addressed(link.hash)) return;
  followed = link.matches("[data-set]") ? link : null;
  if (link.href === location.href) visit(true);
});
})();
