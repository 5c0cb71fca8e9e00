/** Finds the point nearest to a position: points sorted into square cells. */
export class PointGrid {
  private readonly start: Uint32Array;
  private readonly order: Uint32Array;
  private readonly columns: number;
  private readonly rows: number;
  private readonly side: number;

  /** `points`: stride 3, x, y, value, in an image of `width` x `height` px. */
  constructor(
    private readonly points: Float64Array,
    width: number,
    height: number,
  ) {
    const count = points.length / 3;
    // About two points a cell.
    this.side = Math.max(4, Math.sqrt((2 * width * height) / Math.max(count, 1)));
    this.columns = Math.ceil(width / this.side) || 1;
    this.rows = Math.ceil(height / this.side) || 1;
    this.start = new Uint32Array(this.columns * this.rows + 1);
    this.order = new Uint32Array(count);
    const cells = Uint32Array.from({ length: count }, (_, i) => this.cell(points[3 * i] ?? 0, points[3 * i + 1] ?? 0));
    for (const cell of cells) this.start[cell + 1] = (this.start[cell + 1] ?? 0) + 1;
    for (let c = 1; c < this.start.length; c++) this.start[c] = (this.start[c] ?? 0) + (this.start[c - 1] ?? 0);
    const next = this.start.slice();
    cells.forEach((cell, i) => {
      const at = next[cell] ?? 0;
      this.order[at] = i;
      next[cell] = at + 1;
    });
  }

  /** Index of the nearest accepted point within `radius` px; -1 where there is none. */
  nearest(x: number, y: number, radius: number, accept: (index: number) => boolean): number {
    let found = -1;
    let least = radius * radius;
    const [firstColumn, lastColumn] = this.range(x, radius, this.columns);
    const [firstRow, lastRow] = this.range(y, radius, this.rows);
    for (let row = firstRow; row <= lastRow; row++) {
      const line = row * this.columns;
      for (let k = this.start[line + firstColumn] ?? 0; k < (this.start[line + lastColumn + 1] ?? 0); k++) {
        const index = this.order[k] ?? 0;
        const dx = (this.points[3 * index] ?? 0) - x;
        const dy = (this.points[3 * index + 1] ?? 0) - y;
        const distance = dx * dx + dy * dy;
        if (distance <= least && accept(index)) {
          least = distance;
          found = index;
        }
      }
    }
    return found;
  }

  private cell(x: number, y: number): number {
    const column = Math.min(this.columns - 1, Math.max(0, Math.floor(x / this.side)));
    const row = Math.min(this.rows - 1, Math.max(0, Math.floor(y / this.side)));
    return row * this.columns + column;
  }

  private range(centre: number, radius: number, count: number): [number, number] {
    const clamp = (value: number) => Math.min(count - 1, Math.max(0, Math.floor(value / this.side)));
    return [clamp(centre - radius), clamp(centre + radius)];
  }
}
