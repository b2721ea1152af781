// The live view: asks the program for what is new, and puts it into the data that the page shows.
import {el, image} from "./dom.js";
import {showSections, showSummary} from "./summary.js";

const wait_ms = 1000;
const longest_wait_ms = 8000;

export class Live {
  constructor(store, changed) {
    this.store = store;
    this.changed = changed;
    this.wait = wait_ms;
    this.dot = el("span", {class: "pulse"});
    this.words = el("span", {}, "Waiting for the first image");
    this.photo = image("data:image/jpeg;base64,", "");
    this.photo.hidden = true;
    this.caption = el("p", {class: "name"});
    this.latest = el("div", {class: "latest"}, this.photo,
      el("div", {}, el("p", {}, this.dot, this.words), this.caption));
    store.on("loop", () => this.fetchPair());
    this.summary();
    this.poll();
  }

  summary() {
    showSummary(this.store, this.latest);
  }

  async poll() {
    const {data} = this.store;
    try {
      const answer = await fetch(`/news?images=${data.images.count}&layout=${data.layout_version ?? 0}`);
      if (!answer.ok) throw new Error(String(answer.status));
      this.take(await answer.json());
      this.wait = wait_ms;
      this.dot.classList.remove("off");
    } catch {
      // The program has ended, or is busy: what was shown stays.
      this.wait = Math.min(longest_wait_ms, 2 * this.wait);
      this.dot.classList.add("off");
      this.words.textContent = "The program does not answer: the run has ended, or was stopped";
    }
    setTimeout(() => this.poll(), this.wait);
  }

  take(news) {
    const {data} = this.store;
    const append = (columns, more) => {
      for (const [key, values] of Object.entries(more)) columns[key].push(...values);
    };
    const anything = news.names.length > 0;
    if (anything) {
      data.images.names.push(...news.names);
      data.images.count += news.names.length;
      append(data.history, news.history);
      append(data.loops, news.loops);
      data.graph.images.push(...news.graph.images);
      data.graph.paths.push(...news.graph.paths);
      data.graph.nodes = data.graph.images.length;
      data.graph.active = news.graph.active;
    }
    if (news.layout) {
      data.graph.layout = news.layout;
      data.layout_version = news.layout_version;
    }
    if (!anything && !news.layout) return;
    this.placeNewNodes();
    this.store.take(data);
    this.summary();
    this.words.textContent = `Running: ${news.rate.toFixed(1)} images a second`;
    if (anything) this.showLatest();
    this.changed();
    showSections();
  }

  // Until the next layout a node that is new goes on from the two before it.
  placeNewNodes() {
    const {graph} = this.store.data;
    const at = graph.layout;
    const step = this.usualStep(at);
    while (at.length < 2 * graph.nodes) {
      const n = at.length;
      const [x, y] = n >= 2 ? [at[n - 2], at[n - 1]] : [0, 0];
      const [dx, dy] = n >= 4 ? [x - at[n - 4], y - at[n - 3]] : [step, 0];
      const length = Math.hypot(dx, dy) || 1;
      at.push(x + (dx / length) * step, y + (dy / length) * step);
    }
  }

  usualStep(at) {
    const steps = [];
    for (let i = 2; i + 1 < at.length; i += 2) steps.push(Math.hypot(at[i] - at[i - 2], at[i + 1] - at[i - 1]));
    steps.sort((a, b) => a - b);
    return steps[Math.floor(steps.length / 2)] || 10;
  }

  async showLatest() {
    const number = this.store.data.images.count - 1;
    this.caption.textContent = `Image ${number}: ${this.store.file(number)}`;
    const picture = await this.picture(number);
    this.photo.hidden = !picture;
    if (!picture) return;
    this.photo.src = image(picture.photo, "").getAttribute("src");
    this.photo.alt = `The latest image, number ${number}`;
  }

  async picture(number) {
    const known = this.store.picture(number);
    if (known) return known;
    try {
      const answer = await fetch(`/picture/${number}`);
      return answer.ok ? await answer.json() : null;
    } catch {
      return null;
    }
  }

  // The images of the selected loop and what matched in them.
  async fetchPair() {
    const {store} = this;
    const k = store.loop;
    if (k === null || store.pairs.has(k) || store.asking) return;
    store.asking = true;
    store.emit("pair");
    try {
      const answer = await fetch(`/pair/${k}`);
      if (answer.ok) {
        const {pair, pictures} = await answer.json();
        store.data.pairs.push(pair);
        store.pairs.set(k, pair);
        Object.assign(store.data.pictures, pictures);
      }
    } catch {
      // Said by the next poll.
    }
    store.asking = false;
    store.emit("pair");
    this.changed();
    if (store.loop !== k) this.fetchPair();
  }
}
