// The page's data, what is selected, and who wants to know.
import {ScoreScale} from "./colours.js";

export class Store {
  constructor(data) {
    this.listeners = new Map();
    this.loop = null; // number of the selected loop
    this.take(data);
  }

  // New data: a report once, the live view again and again.
  take(data) {
    this.data = data;
    this.pairs = new Map((data.pairs ?? []).map((pair) => [pair.loop, pair]));
    const scores = data.loops.score.slice().sort((a, b) => a - b);
    const high = scores.length ? scores[Math.floor(0.98 * (scores.length - 1))] : data.threshold + 1;
    this.scale = new ScoreScale(data.threshold, high);
    this.emit("data");
  }

  on(event, listener) {
    const list = this.listeners.get(event) ?? [];
    this.listeners.set(event, [...list, listener]);
  }

  emit(event) {
    for (const listener of this.listeners.get(event) ?? []) listener();
  }

  get live() {
    return this.data.kind === "live";
  }
  get loopCount() {
    return this.data.loops.image.length;
  }

  // A loop as one object.
  loopAt(k) {
    const columns = this.data.loops;
    return {
      number: k,
      image: columns.image[k],
      place: this.pairs.get(k)?.view ?? columns.place[k],
      score: columns.score[k],
      rival: columns.rival[k],
      rivalScore: columns.rival_score[k],
      margin: columns.margin[k],
      right: columns.right[k],
      regions: columns.regions[k],
    };
  }

  // `quiet`: not by the reader, so that nothing need be opened or moved for it.
  selectLoop(k, {quiet = false} = {}) {
    if (k === this.loop) return;
    this.loop = k;
    this.quiet = quiet;
    this.emit("loop");
  }

  picture(image) {
    const pictures = this.data.pictures ?? {};
    return Object.hasOwn(pictures, image) ? pictures[image] : null;
  }

  // Images that have a picture with saliency maps, rising.
  pictured() {
    return Object.keys(this.data.pictures ?? {})
      .map(Number)
      .filter((image) => this.data.pictures[image].saliency?.length > 0)
      .sort((a, b) => a - b);
  }

  // Of two traverses, images beyond the queries are references.
  label(image) {
    const queries = this.data.queries;
    if (queries !== undefined && image >= queries) return `reference ${image - queries}`;
    return this.data.candidates > 0 ? `query ${image}` : `image ${image}`;
  }

  file(image) {
    return String(this.data.images.names[image] ?? "");
  }
}
