// Which grains a slow renderer is given: all of the coarse ones while they leave a third of the room to the fines, and an
// even share of the others.

export const softwareLimit = 30_000;

/** Names of renderers that draw on the processor. */
export const isSoftware = (renderer) => /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);

/** Every so-many-th of `rows`, at most `most`, evenly spread. */
function spread(rows, most) {
  if (rows.length <= most) return rows;
  return Array.from({ length: most }, (_, k) => rows[Math.floor((k * rows.length) / most)]);
}

/** Rows to draw of `rows`, at most `limit`. */
export function thinned(rows, isFine, limit) {
  if (rows.length <= limit) return rows;
  const allFines = rows.filter((row) => isFine[row]);
  const coarse = spread(rows.filter((row) => !isFine[row]), limit - Math.min(allFines.length, Math.floor(limit / 3)));
  const fines = spread(allFines, limit - coarse.length);
  return [...coarse, ...fines].sort((a, b) => a - b);
}
