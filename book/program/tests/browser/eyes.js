// What the tests of scenes ask of a page, before its own scripts run.
addEventListener('DOMContentLoaded', () => {
  window.svgs = [...document.querySelectorAll('figure.scene .drawing > svg')];
  window.stills = svgs.map(lines);
});
window.lines = (svg) => [...svg.children].map((node) => node.outerHTML);
window.seen = (figure) => svgs.find((svg) => figure.contains(svg) && svg.getClientRects().length > 0);
// Whether two drawings are the same up to a fiftieth of a pixel, and if not the first line that differs.
window.unlike = (one, other) => {
  const number = /-?\d+(\.\d+)?/g;
  if (one.length !== other.length) return `${one.length} elements and ${other.length}`;
  // A curve may be drawn with a point more or less: the functions of two machines differ in the last bit. An element
  // may hold several curves, each of which is compared with its own.
  const curves = (line) => {
    const node = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    const parts = (/ d="([^"]*)"/.exec(line)?.[1] ?? '').split(/(?=[Mm])/);
    const ends = parts.map((part, k) => {
      node.setAttribute('d', parts.slice(0, k + 1).join(''));
      return node.getTotalLength();
    });
    return ends.map((end, k) => {
      const start = ends[k - 1] ?? 0;
      return { length: end - start, at: (part) => node.getPointAtLength(start + part * (end - start)) };
    });
  };
  const isAlong = (x, y) => [...Array(50).keys()].every((k) => {
    const [p, q] = [x.at((k + 0.5) / 50), y.at((k + 0.5) / 50)];
    return Math.hypot(p.x - q.x, p.y - q.y) < 1;
  });
  const isNear = (a, b) => {
    if (a.replace(/ d="[^"]*"/, '') !== b.replace(/ d="[^"]*"/, '')) return false;
    const [x, y] = [curves(a), curves(b)];
    const isLike = (one, other) => Math.abs(one.length - other.length) < 0.005 * one.length + 0.02 && isAlong(one, other);
    return x.length === y.length && x.every((one, k) => isLike(one, y[k]));
  };
  return one.map((line, index) => [line, other[index]]).find(([a, b]) => {
    const [x, y] = [a, b].map((line) => (line.match(number) ?? []).map(Number));
    const isSame = a.replace(number, '') === b.replace(number, '') && x.every((value, k) => Math.abs(value - y[k]) < 0.0201);
    return !isSame && !isNear(a, b);
  })?.join('\n') ?? '';
};
// What stands beside a picture: its settings as a link, its time, its words and its numbers.
window.shows = (figure) => {
  const link = figure.querySelector('.share a');
  link.dispatchEvent(new Event('pointerdown'));
  const readings = [...figure.querySelectorAll('.readings dd span')].map((place) => place.innerHTML);
  return [link.getAttribute('href'), figure.querySelector('.time').valueAsNumber, figure.querySelector('.says').textContent, readings];
};
// Elements as a page holds them.
window.parsed = (elements) => {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.innerHTML = elements;
  return lines(svg);
};
window.still = (figure) => stills[svgs.indexOf(seen(figure))];
window.drawn = (figure) => lines(seen(figure));
window.asked = 0;
const ask = requestAnimationFrame.bind(window);
window.requestAnimationFrame = (act) => { asked += 1; return ask(act); };
window.frames = async (count) => { for (let k = 0; k < count; k += 1) await new Promise(ask); };
// What has jumped in a scene since the page was there with its fonts: what jumps before, the tests of access measure.
window.shifted = [];
let there = Infinity;
addEventListener('load', () => document.fonts.ready.then(() => { there = performance.now(); }));
new PerformanceObserver((list) => {
  for (const { node } of list.getEntries().filter(({ startTime }) => startTime > there).flatMap((entry) => entry.sources)) {
    const isBlock = node?.nodeType === 1 && !node.closest('dd, output, math');
    if (isBlock && node.parentElement.closest('figure.scene')) shifted.push(`${node.nodeName} ${node.className}`);
  }
}).observe({ type: 'layout-shift', buffered: true });
