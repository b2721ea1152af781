// Section "Loops": all of them in a list that draws only what is in sight, and the chosen one beside it.
import {el, section} from "./dom.js";
import {count, score} from "./format.js";
import {PairView, stepButtons} from "./pair.js";

const row_height = 46;
const spare_rows = 6;

const orders = {
  "by image": (a, b) => a.image - b.image,
  "strongest first": (a, b) => b.score - a.score,
  "weakest first": (a, b) => a.score - b.score,
  "most doubtful first": (a, b) => a.margin - b.margin,
};

export class LoopList {
  constructor(store) {
    this.store = store;
    this.rows = new Map(); // drawn rows by place in the list
    this.all = el("div", {class: "all"});
    this.list = el("div", {
      class: "list",
      role: "listbox",
      tabindex: "0",
      "aria-label": "Loops",
      onscroll: () => this.draw(),
      onkeydown: (event) => this.key(event),
    }, this.all);
    this.order = this.choice("Order", Object.keys(orders));
    this.filter = this.choice("Which", this.filters());
    this.pair = new PairView(store);
    this.place = el("p", {class: "muted"});
    this.build();
    store.on("data", () => this.refresh());
    store.on("loop", () => this.reveal());
    this.refresh();
    if (this.shown.length > 0) store.selectLoop(this.first(), {quiet: true});
    new ResizeObserver(() => this.draw()).observe(this.list);
  }

  // What a reader most wants to see at first: a loop with a picture.
  first() {
    const strongest = (this.store.data.pairs ?? []).find((pair) => pair.why === "strongest");
    return strongest ? strongest.loop : this.shown[0];
  }

  filters() {
    const known = this.store.data.loops.right.some((right) => right !== null);
    const names = ["all", "with pictures"];
    return known ? [...names, "wrong", "right"] : names;
  }

  choice(label, names) {
    return el("select", {"aria-label": label, onchange: () => this.refresh()},
      names.map((name) => el("option", {value: name}, name)));
  }

  build() {
    section(
      "loops",
      "Loops",
      "Images that were taken for a known place. Arrow keys go through the list.",
      el("div", {class: "card loops"},
        el("div", {class: "side"}, el("div", {class: "choose"}, this.filter, this.order), this.list),
        el("div", {}, this.pair.element,
          el("div", {class: "pair tools"}, stepButtons(this), this.place))),
    );
  }

  passes(loop) {
    switch (this.filter.value) {
      case "with pictures":
        return this.store.pairs.has(loop.number);
      case "wrong":
        return loop.right === false;
      case "right":
        return loop.right === true;
      default:
        return true;
    }
  }

  refresh() {
    const loops = [];
    for (let k = 0; k < this.store.loopCount; ++k) loops.push(this.store.loopAt(k));
    this.shown = loops
      .filter((loop) => this.passes(loop))
      .sort(orders[this.order.value])
      .map((loop) => loop.number);
    this.all.style.height = `${this.shown.length * row_height}px`;
    for (const row of this.rows.values()) row.remove();
    this.rows.clear();
    this.all.querySelector(".empty")?.remove();
    if (this.shown.length === 0) this.all.append(el("p", {class: "empty"}, "No such loop."));
    this.draw();
    this.reveal();
  }

  // Rows in sight, and the selected one, so that it can always be pointed at.
  draw() {
    const first = Math.max(0, Math.floor(this.list.scrollTop / row_height) - spare_rows);
    const last = Math.min(
      this.shown.length, Math.ceil((this.list.scrollTop + this.list.clientHeight) / row_height) + spare_rows);
    const wanted = new Set();
    for (let at = first; at < last; ++at) wanted.add(at);
    const selected = this.shown.indexOf(this.store.loop);
    if (selected >= 0) wanted.add(selected);
    for (const [at, row] of this.rows) {
      if (wanted.has(at)) continue;
      row.remove();
      this.rows.delete(at);
    }
    for (const at of [...wanted].sort((a, b) => a - b)) if (!this.rows.has(at)) this.add(at);
    for (const [at, row] of this.rows) row.setAttribute("aria-selected", String(at === selected));
    if (selected >= 0) this.list.setAttribute("aria-activedescendant", `loop-${this.store.loop}`);
    else this.list.removeAttribute("aria-activedescendant");
    this.place.textContent =
      selected >= 0 ? `${selected + 1} of ${this.shown.length}` : count(this.shown.length, "loop");
  }

  add(at) {
    const loop = this.store.loopAt(this.shown[at]);
    const tick = el("span", {class: "tick"});
    tick.style.background = this.store.scale.colour(loop.score);
    const mark = loop.right === null ? (this.store.pairs.has(loop.number) ? "▣" : "") : loop.right ? "✓" : "✕";
    const row = el("div", {
      class: "loop",
      role: "option",
      id: `loop-${loop.number}`,
      "aria-setsize": this.shown.length,
      "aria-posinset": at + 1,
      onclick: () => {
        this.store.selectLoop(loop.number);
        this.list.focus({preventScroll: true});
      },
    },
    tick,
    el("span", {class: "who"}, `${this.store.label(loop.image)} → ${this.store.label(loop.place).replace(/^image /, "")}`,
      el("small", {}, this.store.file(loop.image).split("/").pop())),
    el("span", {class: "score"}, score(loop.score)),
    el("span", {
      class: loop.right === false ? "mark wrong" : "mark",
      title: loop.right === null ? "with pictures" : loop.right ? "right" : "wrong",
    }, mark));
    row.style.top = `${at * row_height}px`;
    const next = [...this.rows.keys()].filter((k) => k > at).sort((a, b) => a - b)[0];
    this.all.insertBefore(row, next === undefined ? null : this.rows.get(next));
    this.rows.set(at, row);
  }

  // The selected loop scrolled into the list's sight.
  reveal() {
    const at = this.shown.indexOf(this.store.loop);
    if (at >= 0) {
      const top = at * row_height;
      const bottom = top + row_height - this.list.clientHeight;
      if (this.list.scrollTop > top) this.list.scrollTop = top;
      else if (this.list.scrollTop < bottom) this.list.scrollTop = bottom;
    }
    this.draw();
  }

  goTo(at) {
    if (this.shown.length === 0) return;
    this.store.selectLoop(this.shown[Math.min(this.shown.length - 1, Math.max(0, at))]);
  }

  step(by) {
    this.goTo(this.shown.indexOf(this.store.loop) + by);
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.list.clientHeight / row_height) - 1);
    const here = this.shown.indexOf(this.store.loop);
    const targets = {
      ArrowDown: here + 1,
      ArrowRight: here + 1,
      ArrowUp: here - 1,
      ArrowLeft: here - 1,
      PageDown: here + page,
      PageUp: here - page,
      Home: 0,
      End: this.shown.length - 1,
    };
    if (!(event.key in targets) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.goTo(targets[event.key]);
  }
}
