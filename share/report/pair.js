// One loop: its two images with the regions that matched, and how sure it is.
import {button, el, image, svg} from "./dom.js";
import {distinct} from "./colours.js";
import {count, score} from "./format.js";

const why_text = {
  strongest: "among the strongest",
  weakest: "among the weakest",
  doubtful: "among the most doubtful",
  wrong: "wrong by ground truth",
};

// Boxes [x, y, width, height, ...] as SVG rectangles in the picture's own pixels.
function boxAt(boxes, k) {
  return {x: boxes[4 * k], y: boxes[4 * k + 1], width: boxes[4 * k + 2], height: boxes[4 * k + 3]};
}

function frame(box, place, colour, width, title) {
  const {x, y, scale} = place;
  const at = {
    x: x + box.x * scale,
    y: y + box.y * scale,
    width: box.width * scale,
    height: box.height * scale,
    fill: "none",
    rx: 2,
  };
  const group = svg("g", {}, svg("rect", {...at, stroke: "rgb(0 0 0 / 65%)", "stroke-width": width + 1.6}),
    svg("rect", {...at, stroke: colour, "stroke-width": width}));
  if (title) group.append(svg("title", {}, title));
  return group;
}

function centre(box, place) {
  return [place.x + (box.x + box.width / 2) * place.scale, place.y + (box.y + box.height / 2) * place.scale];
}

// The images side by side, or one above the other where there is little room.
function places(left, right, beside) {
  const gap = 14;
  const width = 1000;
  if (beside) {
    const each = (width - gap) / 2;
    const a = {x: 0, y: 0, scale: each / left.width};
    const b = {x: each + gap, y: 0, scale: each / right.width};
    return {a, b, width, height: Math.max(left.height * a.scale, right.height * b.scale)};
  }
  const a = {x: 0, y: 0, scale: width / left.width};
  const b = {x: 0, y: left.height * a.scale + gap, scale: width / right.width};
  return {a, b, width, height: b.y + right.height * b.scale};
}

function photo(picture, place, alt) {
  const source = image(picture.photo, "").getAttribute("src");
  return svg("image", {
    href: source,
    x: place.x,
    y: place.y,
    width: picture.width * place.scale,
    height: picture.height * place.scale,
    preserveAspectRatio: "none",
    role: "img",
    "aria-label": alt,
  });
}

// Both images with everything that is known to match.
export function pairFigure(pair, left, right, {beside, regions, names}) {
  const {a, b, width, height} = places(left, right, beside);
  const thick = beside ? 2 : 3.4;
  const out = svg("svg", {class: "figure", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "The two images"});
  out.append(photo(left, a, names[0]), photo(right, b, names[1]));
  const matches = pair.matches ?? [];
  if (regions) {
    for (const [boxes, place] of [[pair.regions ?? [], a], [pair.place_regions ?? [], b]]) {
      for (let k = 0; k < boxes.length / 4; ++k) out.append(frame(boxAt(boxes, k), place, "#cfd6e2", thick / 2));
    }
  }
  const lines = svg("g", {opacity: matches.length > 72 ? 0.5 : 0.85});
  out.append(lines);
  for (let m = 0; m < matches.length; m += 3) {
    const from = boxAt(pair.regions, matches[m]);
    const to = boxAt(pair.place_regions, matches[m + 1]);
    const [x1, y1] = centre(from, a);
    const [x2, y2] = centre(to, b);
    const colour = distinct(m / 3);
    const title = `Descriptor distance ${score(matches[m + 2])}`;
    lines.append(
      svg("line", {x1, y1, x2, y2, stroke: "rgb(0 0 0 / 40%)", "stroke-width": 0.7 * thick + 1.4}),
      svg("line", {x1, y1, x2, y2, stroke: colour, "stroke-width": 0.7 * thick}));
    out.append(frame(from, a, colour, 1.6 * thick, title), frame(to, b, colour, 1.6 * thick, title));
  }
  return out;
}

// Score, threshold and runner-up on one line.
export function gauge(loop, threshold, wide) {
  const width = wide ? 600 : 320;
  const values = [0, threshold, loop.score, loop.rivalScore ?? threshold];
  const least = Math.min(...values);
  const most = Math.max(...values) * 1.04 || 1;
  const x = (value) => 8 + ((width - 16) * (value - least)) / (most - least || 1);
  const mark = (value, text, above) => [
    svg("line", {x1: x(value), x2: x(value), y1: 17, y2: 37, stroke: "var(--ink)", "stroke-width": 2}),
    svg("text", {
      x: x(value),
      y: above ? 12 : 51,
      "text-anchor": x(value) > 0.8 * width ? "end" : x(value) < 0.2 * width ? "start" : "middle",
    }, `${text} ${score(value)}`),
  ];
  const words = `Similarity ${score(loop.score)}, threshold ${score(threshold)}` +
    (loop.rival === null ? "" : `, runner-up ${score(loop.rivalScore)}`);
  return svg("svg", {class: "gauge", viewBox: `0 0 ${width} 54`, role: "img", "aria-label": words},
    svg("rect", {x: 8, y: 22, width: width - 16, height: 10, rx: 5, fill: "var(--rule)"}),
    svg("rect", {x: 8, y: 22, width: Math.max(0, x(loop.score) - 8), height: 10, rx: 5, fill: "var(--accent)"}),
    mark(threshold, "threshold", false),
    loop.rival === null ? [] : mark(loop.rivalScore, "runner-up", true));
}

export class PairView {
  constructor(store) {
    this.store = store;
    this.regions = false;
    this.element = el("div", {class: "pair", "aria-live": "polite"});
    store.on("loop", () => this.show());
    store.on("pair", () => this.show());
    new ResizeObserver(() => {
      if (this.beside !== undefined && this.beside !== this.isWide()) this.show();
    }).observe(this.element);
    this.show();
  }

  isWide() {
    return this.element.clientWidth >= 520;
  }

  show() {
    const {store} = this;
    if (store.loop === null) {
      this.element.replaceChildren(el("p", {class: "empty"}, "No loop is chosen."));
      return;
    }
    const loop = store.loopAt(store.loop);
    const pair = store.pairs.get(store.loop);
    this.element.replaceChildren(
      ...[this.title(loop, pair), this.words(loop, pair), this.figure(loop, pair), this.captions(loop),
        gauge(loop, store.data.threshold, this.isWide()), this.rival(loop)].filter(Boolean));
  }

  title(loop, pair) {
    const verdict =
      loop.right === null
        ? null
        : el("span", {class: loop.right ? "badge right" : "badge wrong"}, loop.right ? "✓ right" : "✕ wrong");
    const why = pair?.why && pair.why !== "wrong" ? el("span", {class: "badge"}, why_text[pair.why]) : null;
    const toggle = el("label", {class: "field"},
      el("input", {type: "checkbox", checked: this.regions, onchange: (event) => {
        this.regions = event.target.checked;
        this.show();
      }}), "all regions");
    return el("div", {class: "title"},
      el("h3", {}, `${this.capital(loop.image)} → ${this.store.label(loop.place)}`, verdict, why),
      pair?.regions?.length ? toggle : null);
  }

  capital(number) {
    const text = this.store.label(number);
    return text[0].toUpperCase() + text.slice(1);
  }

  words(loop, pair) {
    const matched = pair?.matches ? pair.matches.length / 3 : loop.regions;
    return el("p", {class: "note"}, matched === null || matched === undefined || !this.store.data.frontend ? "" :
      `${count(matched, "region")} matched, each in a colour of its own.`);
  }

  figure(loop, pair) {
    const left = this.store.picture(loop.image);
    const right = this.store.picture(loop.place);
    this.beside = this.isWide();
    if (!left || !right) return this.missing(pair);
    return pairFigure(pair ?? {}, left, right, {
      beside: this.beside,
      regions: this.regions,
      names: [this.store.label(loop.image), this.store.label(loop.place)],
    });
  }

  missing(pair) {
    let text = `Not pictured: the page shows ${count(this.store.pairs.size, "loop")} of ` +
      `${this.store.loopCount} (--pairs).`;
    if (pair) text = "Not pictured: an image file could not be read (see the notes at the top).";
    if (this.store.live) text = this.store.asking ? "Asking for the images …" : "The images cannot be shown.";
    return el("p", {class: "empty card"}, text);
  }

  captions(loop) {
    const side = (text, number) =>
      el("div", {class: "name"}, el("b", {}, `${text}: ${this.store.label(number)}`), this.store.file(number));
    return el("div", {class: "captions"}, side("Now", loop.image), side("Known place", loop.place));
  }

  rival(loop) {
    if (loop.rival === null) return null;
    const picture = this.store.picture(loop.rival);
    return el("div", {class: "rival"},
      picture ? image(picture.photo, `The runner-up, ${this.store.label(loop.rival)}`) : null,
      el("p", {class: "name"}, `Runner-up, the best of another place: ${this.store.label(loop.rival)} with ` +
        `${score(loop.rivalScore)}. ${this.store.file(loop.rival)}`));
  }
}

export function stepButtons(list) {
  return el("div", {class: "tools"},
    button("← Previous", () => list.step(-1)), button("Next →", () => list.step(1)));
}
