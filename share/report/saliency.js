// Section "Saliency": what caught the eye in an image of one's choice.
import {button, el, image, section} from "./dom.js";
import {count} from "./format.js";

const map_names = ["Saliency", "Intensity", "Colour", "Orientation"];

export class SaliencyView {
  constructor(store) {
    this.store = store;
    this.images = store.pictured();
    this.strength = 60;
    this.photo = el("div", {class: "over-image"});
    this.maps = el("div", {class: "maps"});
    this.title = el("h3", {class: "name"});
    this.number = el("input", {type: "number", min: "0", step: "1", onchange: () => this.choose(Number(this.number.value))});
    this.strip = el("div", {
      class: "strip",
      role: "listbox",
      "aria-label": "Images with saliency maps",
      "aria-orientation": "horizontal",
      onkeydown: (event) => this.key(event),
    });
    this.build();
    this.fill();
    this.show(this.firstChoice());
  }

  // The image of the loop that is shown above.
  firstChoice() {
    const loop = this.store.loop === null ? null : this.store.loopAt(this.store.loop).image;
    return this.images.includes(loop) ? loop : this.images[0];
  }

  build() {
    const strength = el("input", {type: "range", min: "0", max: "100", value: String(this.strength), oninput: (event) => {
      this.strength = Number(event.target.value);
      this.blend();
    }});
    section("saliency", "Saliency",
      `Where the regions come from. Maps of ${count(this.images.length, "image")} are on this page; ` +
        "--image adds others.",
      el("div", {class: "card"},
        el("div", {class: "looking"},
          el("div", {}, this.title, this.photo),
          el("div", {},
            el("div", {class: "tools"},
              el("label", {class: "field"}, "Image", this.number),
              button("←", () => this.step(-1), {"aria-label": "Previous image"}),
              button("→", () => this.step(1), {"aria-label": "Next image"}),
              el("label", {class: "field"}, "Overlay", strength)),
            el("br"), this.maps)),
        this.strip));
  }

  fill() {
    this.strip.replaceChildren(...this.images.map((number) =>
      el("button", {
        type: "button",
        role: "option",
        id: `look-${number}`,
        tabindex: "-1",
        "aria-label": this.store.label(number),
        onclick: () => this.show(number),
      }, image(this.store.picture(number).photo, ""), el("span", {}, String(number)))));
  }

  // The nearest image that has maps.
  choose(wanted) {
    if (!Number.isFinite(wanted)) return;
    this.show(this.images.reduce((a, b) => (Math.abs(b - wanted) < Math.abs(a - wanted) ? b : a)));
  }

  step(by) {
    const at = this.images.indexOf(this.shown) + by;
    if (at >= 0 && at < this.images.length) this.show(this.images[at]);
  }

  key(event) {
    const by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
    if (by === undefined) return;
    event.preventDefault();
    this.step(by);
    document.getElementById(`look-${this.shown}`)?.focus();
  }

  show(number) {
    this.shown = number;
    const picture = this.store.picture(number);
    this.number.value = String(number);
    this.title.textContent = `${this.store.label(number)} · ${this.store.file(number)}`;
    this.cover = image(picture.saliency[0], "");
    this.photo.replaceChildren(image(picture.photo, `Photograph, ${this.store.label(number)}`), this.cover);
    this.blend();
    this.maps.replaceChildren(...picture.saliency.map((map, k) =>
      el("figure", {}, image(map, `${map_names[k]} map`), el("figcaption", {}, map_names[k]))));
    for (const option of this.strip.children) {
      const chosen = option.id === `look-${number}`;
      option.setAttribute("aria-selected", String(chosen));
      option.tabIndex = chosen ? 0 : -1;
      if (!chosen) continue;
      const middle = option.offsetLeft - this.strip.offsetLeft - this.strip.clientWidth / 2 + option.offsetWidth / 2;
      this.strip.scrollLeft = middle;
    }
  }

  blend() {
    this.cover.style.opacity = String(this.strength / 100);
  }
}
