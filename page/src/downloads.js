// A figure as files: SVG and PNG in the look of print, CSV with the numbers.
import { lowerIndicesOf } from "./indices.js";

const pixelsPerPixel = 3; // PNG: about 290 dots an inch at the chart's own size

export function save(name, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** SVG text with the title and the caption inside, for readers that cannot see it. */
function withWords(svg, { title, caption }) {
  const document_ = new DOMParser().parseFromString(svg, "image/svg+xml");
  const root = document_.documentElement;
  for (const [tag, words] of [["desc", caption], ["title", title]]) {
    const element = document_.createElementNS("http://www.w3.org/2000/svg", tag);
    element.textContent = words;
    root.prepend(element);
  }
  return new XMLSerializer().serializeToString(root);
}

/** The drawing as it stands in the page, without the page's words, which it takes along as its own. */
function drawing(figure) {
  const copy = document.querySelector(`[data-figure="${figure.id}"] .drawing svg`).cloneNode(true);
  for (const name of ["aria-labelledby", "aria-describedby"]) copy.removeAttribute(name);
  return copy;
}

async function svgOf({ figure, chart }) {
  if (!chart) return withWords(new XMLSerializer().serializeToString(drawing(figure)), figure);
  const view = await chart.printed();
  const svg = lowerIndicesOf(await view.toSVG());
  view.finalize();
  return withWords(svg, figure);
}

/** From the SVG, so that both show the same. */
async function canvasOf(what) {
  const svg = await svgOf(what);
  const { width, height } = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement.viewBox.baseVal;
  const image = new Image();
  image.src = "data:image/svg+xml," + encodeURIComponent(svg);
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = Math.round(width * pixelsPerPixel);
  canvas.height = Math.round(height * pixelsPerPixel);
  const context = canvas.getContext("2d");
  context.fillStyle = "white";
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

const kinds = {
  SVG: async (what) => new Blob([await svgOf(what)], { type: "image/svg+xml" }),
  PNG: async (what) => {
    const canvas = await canvasOf(what);
    return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
  },
  CSV: async ({ figure }) => new Blob([figure.csv], { type: "text/csv" }),
};

/** A button a kind of file; in place of the link to the file next to the report, which may have been left behind. */
export function addButtons(place, what) {
  for (const [kind, make] of Object.entries(kinds)) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = kind;
    button.setAttribute("aria-label", `Save as ${kind}: ${what.figure.title}`);
    button.addEventListener("click", async () => {
      save(`${what.run}-${what.figure.id}.${kind.toLowerCase()}`, await make(what));
    });
    place.append(button);
  }
  place.parentElement.querySelector("a")?.remove();
}
