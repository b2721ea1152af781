// Reads the data and shows what there is of it.
import {CurveView} from "./curve.js";
import {showDetails} from "./details.js";
import {Live} from "./live.js";
import {LoopList} from "./loops.js";
import {MapView} from "./map_view.js";
import {MatrixView} from "./matrix.js";
import {SaliencyView} from "./saliency.js";
import {Store} from "./store.js";
import {showFoot, showSections, showSummary} from "./summary.js";
import {Timeline} from "./timeline.js";

const store = new Store(JSON.parse(document.getElementById("data").textContent));

// Each section once, as soon as there is something in it.
const shown = new Set();
function once(name, ready, make) {
  if (shown.has(name) || !ready) return;
  shown.add(name);
  make();
}

function showAll() {
  const {data} = store;
  once("map", data.graph?.nodes > 0, () => new MapView(store));
  once("loops", store.loopCount > 0, () => new LoopList(store));
  once("precision", data.evaluation, () => new CurveView(store));
  once("timeline", data.history?.score.length > 0, () => new Timeline(store));
  once("matrix", data.matrix, () => new MatrixView(store));
  once("saliency", store.pictured().length > 0, () => new SaliencyView(store));
  once("details", true, () => showDetails(store));
}

if (!store.live) showSummary(store);
showAll();
showSections();
showFoot(store.data);
if (store.live) new Live(store, showAll);
