// The report's page: draws the charts whose specifications and numbers the program left in it, and offers them as files.
import { Chart } from "./chart.js";
import { addButtons } from "./downloads.js";
import { showScene } from "./scene/index.js";

const { run, look, figures } = JSON.parse(document.getElementById("report-data").textContent);
const charts = [];
document.getElementById("no-script")?.remove();

for (const figure of figures) {
  const place = document.querySelector(`[data-chart="${figure.id}"]`);
  const chart = place ? new Chart(figure, look, place) : null;
  if (chart) charts.push(chart);
  addButtons(document.querySelector(`[data-buttons="${figure.id}"]`), { run, figure, chart });
}

/** One after the other, so that the first is seen while the last is still being drawn. */
async function drawAll() {
  for (const chart of charts) {
    await chart.draw();
    await new Promise((resume) => setTimeout(resume));
  }
  if (!document.documentElement.dataset.drawn) showScene(run);
  document.documentElement.dataset.drawn = "all";
}

let waiting;
addEventListener("resize", () => {
  clearTimeout(waiting);
  waiting = setTimeout(drawAll, 150);
});
drawAll();
