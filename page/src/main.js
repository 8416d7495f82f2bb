// The report's page: draws the charts whose specifications and numbers the program left in it, and offers them as files.
import { Chart } from "./chart.js";
import { addButtons } from "./downloads.js";
import { showScene } from "./scene/index.js";
import { unpacked } from "./unpack.js";

const charts = [];

/** Reads the data, and gives each figure its chart and its buttons. @return the run's name. */
async function open() {
  const { run, look, figures } = await unpacked("report-data");
  document.getElementById("no-script")?.remove();
  for (const figure of figures) {
    const place = document.querySelector(`[data-chart="${figure.id}"]`);
    const chart = place ? new Chart(figure, look, place) : null;
    if (chart) charts.push(chart);
    addButtons(document.querySelector(`[data-buttons="${figure.id}"]`), { run, figure, chart });
  }
  return run;
}

let scene; // begun once, however often the window changes its size meanwhile

/** One after the other, so that the first is seen while the last is still being drawn. */
async function drawAll(run) {
  for (const chart of charts) {
    await chart.draw();
    await new Promise((resume) => setTimeout(resume));
  }
  scene ??= unpacked("scene-data").then((data) => showScene(run, data));
  await scene;
  document.documentElement.dataset.drawn = "all";
}

open().then((run) => {
  let waiting;
  addEventListener("resize", () => {
    clearTimeout(waiting);
    waiting = setTimeout(drawAll, 150, run);
  });
  return drawAll(run);
});
