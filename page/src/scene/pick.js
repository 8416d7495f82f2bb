// Which grain lies under a point of the picture: the same geometry as the shader of the spheres.

/**
 * Row of the grain nearest to the eye at (x, y) in the camera's space, or -1. `toCamera` is a column-major 4 x 4 matrix;
 * `clip` keeps points with clip[0..2] . point <= clip[3].
 */
export function grainAt(x, y, rows, position, radius, size, toCamera, clip) {
  let best = -1;
  let nearest = -Infinity;
  const m = toCamera;
  for (const row of rows) {
    const [px, py, pz] = [position[3 * row], position[3 * row + 1], position[3 * row + 2]];
    const dx = x - (m[0] * px + m[4] * py + m[8] * pz + m[12]);
    const dy = y - (m[1] * px + m[5] * py + m[9] * pz + m[13]);
    const r = size * radius[row];
    const rest = r * r - dx * dx - dy * dy;
    if (rest < 0) continue;
    const half = Math.sqrt(rest);
    const middle = m[2] * px + m[6] * py + m[10] * pz + m[14];
    let z = middle + half;
    if (clip[0] * x + clip[1] * y + clip[2] * z > clip[3]) {
      if (clip[2] < 1e-4) continue;
      z = (clip[3] - clip[0] * x - clip[1] * y) / clip[2];
      if (Math.abs(z - middle) > half) continue;
    }
    if (z > nearest) [best, nearest] = [row, z];
  }
  return best;
}
