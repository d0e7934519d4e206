// Numbers that answer. The module holds each snippet that has live numbers as a function of them; this script brings
// the numbers from the panel beside the code to the module, and what the program prints and finds back to the page.
(() => {
"use strict";
const { Machine, whenNear } = window.spinning;

/** The instance that runs the snippets of this page, made anew after a program has panicked. */
let machine = null;

/** A number in the page’s form: a true minus, and powers of ten, without a one before them. */
const pretty = (text) =>
  text.replace(/e(-?\d+)/g, "·10<sup>$1</sup>").replace(/(?<![\d.])1·/g, "").replaceAll("-", "−");

/** Makes an element of its own of the words that stand at a place of some code, so that they can change. */
function piece(code, start, length) {
  const walk = document.createTreeWalker(code, NodeFilter.SHOW_TEXT);
  for (let node = walk.nextNode(), at = 0; node; at += node.length, node = walk.nextNode()) {
    if (at + node.length <= start) continue;
    if (at > start || start + length > at + node.length) return null; // coloured as several
    const words = node.splitText(start - at);
    words.splitText(length);
    const span = document.createElement("span");
    span.className = "answer";
    words.replaceWith(span);
    span.append(words);
    return span;
  }
  return null;
}

class Program {
  #frame = 0;
  #isFailed = false;
  /** What to say of a number that was typed, and is taken as another. */
  #beyond = "";

  constructor(panel) {
    const all = (selector) => [...panel.querySelectorAll(selector)];
    this.panel = panel;
    [this.outputs, this.checks] = [all("dd > output"), all("li")];
    [this.says, this.reset, this.note] = [".says", ".reset", ".note-of-text"].map((part) => panel.querySelector(part));
    this.remarks = all("i").map(({ dataset: { of, check, words } }) => ({ of: of?.split(" "), check, words }));
    this.live = all(".number").map((number) => {
      const [field, range] = number.querySelectorAll("input");
      const { name, decimals } = field.dataset;
      const [least, most, start] = [field.min, field.max, field.defaultValue].map(Number);
      return { name, field, range, least, most, start, value: start, decimals: Number(decimals) };
    });
    this.#findPieces(panel.parentElement.querySelector("pre > code"));
    for (const live of this.live) {
      [live.field.value, live.range.value] = [live.field.defaultValue, live.start]; // whatever the browser remembers
      live.field.addEventListener("input", () => {
        const typed = live.field.valueAsNumber;
        this.#take(live, typed, false);
        const range = typed < live.least || typed > live.most ? ` goes from ${live.least} to ${live.most}` : "";
        const isOther = !Number.isNaN(typed) && live.value !== typed;
        this.#beyond = isOther ? `${live.name}${range}: it is taken as ${live.value}.`.replaceAll("-", "−") : "";
      });
      live.field.addEventListener("change", () => this.#take(live, live.value, true));
      live.range.addEventListener("input", () => {
        this.#beyond = "";
        this.#take(live, live.range.valueAsNumber, true);
      });
    }
    this.reset.addEventListener("click", () => {
      this.#beyond = "";
      for (const live of this.live) this.#take(live, live.start, true);
      this.live[0].field.focus();
    });
    // The arrow keys belong to the field that has them, and not to the book, whose pages they would turn.
    panel.addEventListener("keydown", (event) => {
      if (event.target.matches("input") && event.key.startsWith("Arrow")) event.stopPropagation();
    });
    whenNear(panel, () => this.#machine().catch((error) => this.#fail(error)));
  }

  /** Where numbers and printed values stand in the code. */
  #findPieces(code) {
    for (const live of this.live) {
      const found = new RegExp(`\\blet ${live.name}\\b[^=\\n]*= `).exec(code.textContent);
      const start = found && found.index + found[0].length;
      live.piece = found && piece(code, start, live.field.defaultValue.length);
    }
    let from = 0;
    for (const output of this.outputs) {
      output.start = output.dataset.value;
      from = code.textContent.indexOf(`// → ${output.start}`, from) + "// → ".length;
      output.piece = from < 5 ? null : piece(code, from, output.start.length);
    }
    for (const remark of this.remarks) {
      const start = code.textContent.indexOf(remark.words);
      remark.piece = start < 0 ? null : piece(code, start, remark.words.length);
    }
  }

  #machine() {
    machine ??= Machine.at(this.panel.dataset.module);
    return machine;
  }

  /** A number is this now; `isWhole`: the reader has finished it, and the field may be written. */
  #take(live, value, isWhole) {
    if (Number.isNaN(value)) return; // half a number
    // With as many digits as the code has room for: one that counts stays whole.
    live.value = Number(Math.min(Math.max(value, live.least), live.most).toFixed(live.decimals));
    const isStart = live.value === live.start;
    const text = isStart ? live.field.defaultValue : live.value.toFixed(live.decimals);
    if (isWhole) live.field.value = text;
    live.range.value = live.value;
    live.range.setAttribute("aria-valuetext", text);
    if (live.piece) live.piece.textContent = text;
    live.piece?.classList.toggle("changed", !isStart);
    this.#frame ||= requestAnimationFrame(() => this.#run());
  }

  async #run() {
    this.#frame = 0;
    if (this.#isFailed) return;
    const values = this.live.map(({ value }) => value);
    let running;
    try {
      running = await this.#machine();
      running.numbers(values.length).set(values);
      const lines = running.text(running.run.run(Number(this.panel.dataset.snippet), values.length));
      this.#show(lines.split("\n"));
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) return this.#fail(error);
      machine = null; // it is thrown away
      const silent = [...this.outputs.map(() => "="), ...this.checks.map(() => "?")];
      this.#show([...silent, `!the program panicked: ${running.cause(error)}`]);
    }
  }

  #show(lines) {
    this.outputs.forEach((output, index) => {
      const text = lines[index].slice(1) || "–";
      const html = pretty(text);
      if (output.innerHTML !== html) output.innerHTML = html;
      if (output.piece) output.piece.textContent = text;
      output.piece?.classList.toggle("changed", text !== output.start);
    });
    this.checks.forEach((check, index) => {
      const [sign, ...by] = lines[this.outputs.length + index];
      const [name, words] = {
        "+": ["holds", "holds"],
        "-": ["fails", "fails"],
        "?": ["unread", "is not reached"],
      }[sign];
      check.className = name;
      check.querySelector("b").textContent = words;
      check.querySelector(".by").innerHTML = by.length > 0 ? ` (${pretty(by.join(""))})` : "";
    });
    const changed = this.live.filter(({ value, start }) => value !== start).map(({ name }) => name);
    for (const { piece, of, check } of this.remarks) {
      const isOld = of ? of.some((name) => changed.includes(name)) : this.checks[check].className === "fails";
      piece?.classList.toggle("of-text", isOld);
    }
    if (this.note) this.note.hidden = !this.remarks.some(({ piece }) => piece?.classList.contains("of-text"));
    const trouble = lines.find((line) => line.startsWith("!"));
    this.says.textContent = [this.#beyond, trouble && `It ends early: ${trouble.slice(1)}.`].filter(Boolean).join(" ");
    this.reset.disabled = changed.length === 0;
  }

  /** The module does not run here: the code stays, with the numbers of the text. */
  #fail(error) {
    this.#isFailed = true;
    console.warn(`snippet ${this.panel.dataset.snippet}: ${error.message}`);
    this.panel.classList.add("failed");
    for (const { field, range } of this.live) field.disabled = range.disabled = true;
    this.says.textContent = "These numbers cannot be changed here: the module of the pages did not run.";
  }
}

for (const panel of document.querySelectorAll(".answers[data-module]")) new Program(panel);
})();
