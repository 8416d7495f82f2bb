// What is written over the picture: the axes, where the water goes, a scale bar. SVG, so that it stays sharp and readable.

const svg = "http://www.w3.org/2000/svg";

function element(name, attributes, text) {
  const made = document.createElementNS(svg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  return made;
}

/** 1, 2 or 5 times a power of ten, at most `most`. */
export function roundLength(most) {
  const decade = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((k) => k * decade).find((length) => length <= most * (1 + 1e-12));
}

export class Overlay {
  constructor(scene) {
    this.scene = scene;
    this.node = element("svg", { class: "overlay", "aria-hidden": "true" });
  }

  arrow(x, y, [dx, dy], length, name, css) {
    const [tipX, tipY] = [x + dx * length, y - dy * length];
    const reach = Math.hypot(dx, dy);
    this.node.append(element("line", { x1: x, y1: y, x2: tipX, y2: tipY, class: css }));
    if (reach > 0.15) {
      const [ux, uy] = [dx / reach, -dy / reach];
      const corners = [[0, 0], [-8, 3.5], [-8, -3.5]].map(([a, b]) => `${tipX + ux * a - uy * b},${tipY + uy * a + ux * b}`);
      this.node.append(element("polygon", { points: corners.join(" "), class: css }));
    }
    this.node.append(element("text", { x: tipX + dx * 12, y: tipY - dy * 12 + 4, "text-anchor": "middle", class: css }, name));
  }

  /** Around the chosen grain, which others may hide. */
  ring({ x, y }, radius) {
    for (const css of ["halo", "ring"]) this.node.append(element("circle", { cx: x, cy: y, r: Math.max(radius, 3) + 3, class: css }));
  }

  /** `right`, `up`: the camera's; `perMillimeter`: pixels; `gradient`: what drives the water. */
  draw(width, height, right, up, perMillimeter, gradient) {
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.node.replaceChildren();
    const seen = (v) => [right[0] * v[0] + right[1] * v[1] + right[2] * v[2], up[0] * v[0] + up[1] * v[1] + up[2] * v[2]];
    const [x, y] = [56, height - 56];
    this.arrow(x, y, seen([1, 0, 0]), 32, "x", "axis");
    this.arrow(x, y, seen([0, 1, 0]), 32, "y", "axis");
    this.arrow(x, y, seen([0, 0, 1]), 32, "z", "axis");
    const flow = this.scene.flowDirection;
    if (Math.hypot(...flow) > 0) {
      const drawn = seen(flow);
      this.arrow(136 - 20 * drawn[0], y - 12 + 20 * drawn[1], drawn, 40, "", "water");
      this.node.append(element("text", { x: 136, y: height - 16, "text-anchor": "middle", class: "water" }, `water, i = ${gradient}`));
    }
    const length = roundLength((0.2 * width) / perMillimeter);
    const end = width - 20;
    const begin = end - length * perMillimeter;
    this.node.append(element("path", { d: `M${begin} ${height - 30}v8H${end}v-8`, class: "bar" }));
    const name = length >= 1 ? `${length} mm` : `${Number((1000 * length).toPrecision(3))} µm`;
    this.node.append(element("text", { x: (begin + end) / 2, y: height - 34, "text-anchor": "middle", class: "scale" }, name));
  }
}
