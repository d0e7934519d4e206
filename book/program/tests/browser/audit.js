// What the tests of access ask of a page. Each answer is a list of faults, each with its element and its place.

// How far parts of the page have jumped so far.
window.shift = 0;
new PerformanceObserver((list) => {
  for (const { value, hadRecentInput } of list.getEntries()) shift += hadRecentInput ? 0 : value;
}).observe({ type: 'layout-shift', buffered: true });

// The way to an element that a maintainer can follow: what has an id, and what lies below it.
const named = (node) => {
  const id = node.closest('[id]')?.id;
  const own = [node.localName, ...node.classList].join('.');
  const words = [...node.textContent.trim().replace(/\s+/g, ' ')].slice(0, 30).join('');
  return `${id ? `#${id} ` : ''}${id === node.id ? '' : `${own} `}“${words}”`;
};
const shown = (node) => node.getClientRects().length > 0 && node.checkVisibility({ visibilityProperty: true });

// What axe finds. It does not know that a formula is text that is read aloud, so a head of formulas looks empty to it.
// Of given rules alone, if there are any; without others.
window.audit = async (only, without) => {
  axe.configure({ rules: [{ id: 'empty-table-header', selector: 'th:not(:has(math))' }] });
  const rules = Object.fromEntries(without.map((rule) => [rule, { enabled: false }]));
  const found = await axe.run(document, { resultTypes: ['violations'], rules, ...(only.length > 0 && { runOnly: only }) });
  return found.violations.flatMap(({ id, nodes }) => nodes.map(({ target, html, any, all, none }) => {
    const why = [...any, ...all, ...none][0]?.message ?? '';
    return `${id}: ${target.join(' ')}: ${why} (${html.slice(0, 120)})`;
  }));
};

// What a reader who does not see is told of pictures, tables and the page.
window.untold = () => {
  const faults = [];
  // Of a figure of panels the first speaks for all, and the others are silent. Of one in a closed fold all that may be shown must speak.
  for (const figure of document.querySelectorAll('main figure')) {
    const isFolded = figure.closest('details:not([open])') !== null;
    const speaking = [...figure.querySelectorAll('.drawing svg')].filter((svg) => (isFolded || shown(svg)) && svg.ariaHidden !== 'true');
    const isTold = (svg) => {
      const told = ['title', 'desc'].map((name) => svg.querySelector(`:scope > ${name}`));
      const ids = svg.getAttribute('aria-labelledby')?.split(' ') ?? [];
      return svg.getAttribute('role') === 'img' && told.every((node) => node?.textContent.trim() && ids.includes(node.id));
    };
    if (speaking.length === 0 || !speaking.every(isTold)) faults.push(`a figure without title and description: ${named(figure)}`);
  }
  for (const table of document.querySelectorAll('main table')) {
    const heads = [...table.querySelectorAll('th')];
    const isHeaded = heads.length > 0 && heads.every((head) => head.scope === 'col' || head.scope === 'row');
    if (!isHeaded) faults.push(`a table without heads: ${named(table)}`);
  }
  if (document.documentElement.lang !== 'en-GB') faults.push(`the language is “${document.documentElement.lang}”`);
  return faults;
};

// Boxes whose content scrolls sideways. The page itself is none of them; that of lost readers has no frame.
const content = () => document.getElementById('mdbook-content') ?? document.body;
const scrolls = (node) => /auto|scroll/.test(getComputedStyle(node).overflowX) && node.scrollWidth > node.clientWidth;
const inScroller = (node) => {
  for (let box = node.parentElement; box !== null && box !== content(); box = box.parentElement) if (scrolls(box)) return true;
  return false;
};
// Content that can be cut: text, maths, tables, code, pictures, what can be operated.
const CONTENT = 'p, li, dt, dd, h1, h2, h3, h4, figcaption, caption, summary, math, table, pre, code, svg, button, input, a, label, output';

// What sticks out of the window sideways, where nothing scrolls it back, or is cut off by a box that hides its rest, with all
// that folds unfolded.
window.wide = () => {
  document.querySelectorAll('main details').forEach((fold) => { fold.open = true; });
  const root = document.documentElement;
  const faults = [];
  for (const page of [root, content()]) {
    if (page.scrollWidth > page.clientWidth) faults.push(`the page is ${page.scrollWidth} px wide`);
  }
  for (const node of content().querySelectorAll(CONTENT)) {
    const box = node.getBoundingClientRect();
    const isOut = box.width > 1 && (box.right > root.clientWidth + 1 || box.left < -1);
    if (isOut && shown(node) && !inScroller(node)) faults.push(`out of sight: ${named(node)} to ${Math.round(box.right)} px`);
    const isCut = /hidden|clip/.test(getComputedStyle(node).overflowX) && node.scrollWidth > node.clientWidth + 1;
    if (isCut && node.clientWidth > 1 && shown(node) && !inScroller(node)) faults.push(`cut off: ${named(node)}`);
  }
  return faults;
};

// What paper of a height, px, cuts off: it cannot scroll.
window.offPaper = (height) => {
  const page = document.querySelector('main').getBoundingClientRect();
  const faults = [];
  const whole = 'math, svg, table, pre, figure, figcaption, .equation, .formula, .note, .hint, p, li, td, th, h1, h2, h3, h4';
  for (const node of document.querySelectorAll(`main :is(${whole})`)) {
    const box = node.getBoundingClientRect();
    if (!shown(node) || box.width === 0) continue;
    if (box.right > page.right + 1 || box.left < page.left - 1) {
      faults.push(`off the paper: ${named(node)} from ${Math.round(box.left - page.left)} to ${Math.round(box.right - page.left)} of ${Math.round(page.width)} px`);
    }
    if (node.matches('svg, math, .equation, .figure') && box.height > height) faults.push(`higher than the paper: ${named(node)}, ${Math.round(box.height)} px`);
  }
  const boxes = '.formula, .table-wrapper, pre, pre > code, figure, figcaption, .equation, .note, .hint, p, li, td, th, h1, h2, h3, h4';
  for (const box of document.querySelectorAll(`main :is(${boxes})`)) {
    const style = getComputedStyle(box);
    const isCut = style.overflowX !== 'visible' || box.matches('.formula, .table-wrapper, pre, pre > code, figcaption, p, li, td, th, h1, h2, h3, h4');
    if (isCut && style.display !== 'inline' && shown(box) && box.clientWidth > 0 && box.scrollWidth > box.clientWidth + 1) {
      faults.push(`cut off on paper: ${named(box)}`);
    }
  }
  return faults;
};

// Whether what is read one after another stands so on the page. A note in the margin begins no higher than its paragraph
// does, and below the notes before it; so does the caption of a figure beside its drawing.
window.disordered = () => {
  const faults = [];
  const top = (node) => node.getBoundingClientRect().top;
  const blocks = [...document.querySelectorAll('main > *')].filter(shown);
  const isBeside = (node) => getComputedStyle(node).float !== 'none';
  const flows = [blocks.filter((node) => !isBeside(node)), [...document.querySelectorAll('main :is(.note, figcaption, .figure.margin)')].filter((node) => shown(node) && isBeside(node))];
  for (const flow of flows) {
    flow.forEach((node, index) => {
      if (index > 0 && top(node) < top(flow[index - 1]) - 1) faults.push(`stands above what is read before it: ${named(node)}`);
    });
  }
  for (const note of document.querySelectorAll('main .note')) {
    const before = note.previousElementSibling;
    if (before && shown(note) && top(note) < top(before) - 12) faults.push(`a note above its paragraph: ${named(note)}`);
  }
  return faults;
};

// What stands in the margin and covers something else there: what hangs in it, or reaches into it from the text. Code ends
// well before what stands beside it.
window.crowded = () => {
  const beside = [...document.querySelectorAll('main *')].filter((node) => shown(node) && getComputedStyle(node).float === 'right');
  const edge = Math.min(...beside.map((node) => node.getBoundingClientRect().left));
  const reach = (node) => {
    const isCode = node.matches('pre > code');
    const text = document.createRange(); // its box goes to the margin, wherever its lines end
    text.selectNodeContents(node);
    const { left, right, top, bottom } = (isCode ? text : node).getBoundingClientRect();
    return { left, right: right + (isCode ? 16 : 0), top, bottom };
  };
  const inText = [...document.querySelectorAll(`main :is(${CONTENT})`)].filter((node) => shown(node) && !node.matches('pre') && reach(node).right > edge + 1);
  const covers = (a, b) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  return beside.flatMap((node, index) => {
    const others = [...beside.slice(index + 1), ...inText].filter((other) => !node.contains(other) && !other.contains(node));
    return others.filter((other) => covers(reach(node), reach(other))).map((other) => `${named(node)} covers ${named(other)}`);
  });
};

// What has the focus: how it is called, and what is wrong with how it shows.
window.focused = () => {
  const node = document.activeElement;
  if (node === document.body || node === null) return null;
  const box = node.getBoundingClientRect();
  const style = getComputedStyle(node);
  const faults = [];
  const ring = style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 1.5;
  if (!ring && style.boxShadow === 'none') faults.push('no ring');
  if (box.width === 0 || style.visibility !== 'visible') faults.push('unseen');
  // Of a link over two lines each has a box; one that is seen is enough.
  const isClear = [...node.getClientRects()].some((part) => {
    const at = document.elementFromPoint(part.left + Math.min(part.width / 2, 20), part.top + part.height / 2);
    return at !== null && (node.contains(at) || at.contains(node));
  });
  if (!isClear) faults.push('covered or out of sight');
  const place = ['#mdbook-sidebar', '#mdbook-menu-bar', 'figure.scene', '.answers', 'main', '.foot'].find((part) => node.closest(part));
  return { name: node.id ? `#${node.id}` : named(node), place: place ?? 'page', faults };
};
