/** A plot of a block: points or bars over two axes; hovered, pressed and brushed in step with all other views. */
import type { Colours } from '../../../shared/view/colours';
import { within } from '../../../shared/view/layers';
import { toCanvas, toPosition } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import { asFigure, asSentence } from '../../../shared/text/direction';
import { fixed } from '../../../shared/text/format';
import { remember } from '../../../shared/state/remember';
import type { BlockStore } from '../../engine/engine';
import type { Facts } from '../../engine/facts';
import { plotOf } from '../../state/plots';
import type { PlotData, PlotName } from '../../state/plots';
import type { Choice } from '../../state/selection';
import type { BlockView } from '../../state/view';
import { Chart } from '../chart';
import type { Drawn } from '../chart';
import type { Looking } from '../looking';
import { decimalsOf, endsOf, laidOut, LEGEND, namesWritten, ROOM, ticksBetween, ticksOfPowers, titleOf, titleWithin, UPRIGHT_MOST } from './axes';
import type { Ends, Laid } from './axes';
import { withUnit } from '../../../shared/text/units';

/** How near the pointer must be to a point, CSS px. */
const REACH = 9;
/** Ticks are about so far apart, CSS px. */
const APART = { x: 90, y: 46 } as const;
const LEAST_TICKS = 3;
/** Up to so many points are drawn larger. */
const FEW = 3000;
const FONT = '11px system-ui, sans-serif';
/** What is infinite stands so far below the upper edge, CSS px. */
const INSIDE = 4;
/** Half a mark of a group, and half the end of a whisker, CSS px. */
const MARK = 4;
const CAP = 3;
/** Bars leave so much of their place free. */
const GAP = 0.25;

export class Plot extends Chart {
  private name: PlotName = 'images';
  private outline: Drawn | null = null;
  private readonly listeners: (() => void)[] = [];

  constructor(
    host: HTMLElement,
    store: BlockStore,
    looking: Looking,
    private readonly facts: Facts,
  ) {
    super(host, 'plot', store, looking);
    facts.watch(() => this.changed());
    store.watch(['shown', 'onStage'], () => this.changed());
  }

  /** Calls back when other values may be shown. */
  watch(changed: () => void): void {
    this.listeners.push(changed);
  }

  get shows(): PlotName {
    return this.name;
  }

  show(name: PlotName): void {
    this.name = name;
    this.fit();
    this.changed();
  }

  /** What is shown; null while it is on its way, or while the plot is not looked at. */
  data(): PlotData | null {
    const view = this.view();
    return view === null || this.store.state.onStage !== 'plots' ? null : plotOf(this.name, view, this.facts);
  }

  /** The picture as it stands. */
  picture(): HTMLCanvasElement {
    return this.layers.snapshot();
  }

  private changed(): void {
    this.layers.redraw();
    for (const listener of this.listeners) listener();
  }

  protected override readonly enclosed = (_: BlockView, drawn: Drawn, ended: boolean): void => {
    this.outline = ended || drawn.to === null ? null : drawn;
    const data = this.data();
    const view = this.view();
    if (ended && drawn.to !== null && data !== null && view !== null) {
      const [[x0, y0], [x1, y1]] = [drawn.from, drawn.to];
      const [left, right, top, bottom] = [Math.min(x0, x1), Math.max(x0, x1), Math.min(y0, y1), Math.max(y0, y1)];
      const place = this.placing(data, this.current(view));
      const rows: number[] = [];
      for (let row = 0; row < data.x.values.length; row++) {
        const [x, y] = place(row);
        // A bar is met anywhere on its way to its end.
        const meets = data.bars ? y <= bottom && this.base(data, this.current(view)) >= top : y >= top && y <= bottom;
        if (x >= left && x <= right && meets) rows.push(row);
      }
      this.looking.choose(data.together(rows));
    }
    this.layers.redraw();
  };

  protected override whole(): Transform {
    return { scale: 1, x: 0, y: 0 };
  }

  protected override limits(): { least: number; most: number } {
    return { least: 1, most: 500 };
  }

  /** The values stay where their axes are. */
  protected override held(_: BlockView, { scale, x, y }: Transform): Transform {
    const { width, height } = this.layers;
    return { scale, x: Math.min(0, Math.max((1 - scale) * width, x)), y: Math.min(0, Math.max((1 - scale) * height, y)) };
  }

  protected override hit(_: BlockView, t: Transform, x: number, y: number): Choice | null {
    const data = this.data();
    const row = data === null ? -1 : this.nearest(data, t, x, y);
    return data === null || row < 0 ? null : data.choice(row);
  }

  protected override command(): boolean {
    return false;
  }

  private laid(data: PlotData): Laid {
    return laidWithin(data, this.layers.width);
  }

  private area(data: PlotData): Rect {
    const { width, height } = this.layers;
    const { left, right, top, bottom } = this.laid(data).room;
    return { left, top, width: Math.max(1, width - left - right), height: Math.max(1, height - top - bottom) };
  }

  /** Where values lie on the canvas. */
  private placing(data: PlotData, t: Transform): (row: number) => [number, number] {
    const at = this.scaling(data, t);
    return (row) => at(data.x.values[row] ?? NaN, data.y.values[row] ?? NaN);
  }

  private scaling(data: PlotData, t: Transform): (x: number, y: number) => [number, number] {
    const { left, top, width, height } = this.area(data);
    const ends = endsOf(data, this.layers.width, this.layers.height);
    const [x0, across] = [ends.x[0], width / (ends.x[1] - ends.x[0])];
    const [y0, up] = [ends.y[0], height / (ends.y[1] - ends.y[0])];
    const upwards = data.y.logarithmic === true ? Math.log10 : (y: number) => y;
    const upper = (y: number) => (y === Infinity ? top + INSIDE : top + height - (upwards(y) - y0) * up);
    return (x, y) => toCanvas(t, left + (x - x0) * across, upper(y));
  }

  /** The values at the edges of what is seen. */
  private seen(data: PlotData, t: Transform): { x: Ends; y: Ends } {
    const { left, top, width, height } = this.area(data);
    const ends = endsOf(data, this.layers.width, this.layers.height);
    const value = (x: number, y: number): [number, number] => {
      const [u, v] = toPosition(t, x, y);
      return [ends.x[0] + ((u - left) / width) * (ends.x[1] - ends.x[0]), ends.y[0] + ((top + height - v) / height) * (ends.y[1] - ends.y[0])];
    };
    const [from, to] = [value(left, top + height), value(left + width, top)];
    return { x: [from[0], to[0]], y: [from[1], to[1]] };
  }

  /** Where bars stand. */
  private base(data: PlotData, t: Transform): number {
    return this.scaling(data, t)(0, 0)[1];
  }

  private barWidth(data: PlotData, t: Transform): number {
    const [[x0], [x1]] = [this.scaling(data, t)(0, 0), this.scaling(data, t)(1, 0)];
    return Math.max(1, (1 - GAP) * (x1 - x0));
  }

  private nearest(data: PlotData, t: Transform, x: number, y: number): number {
    const place = this.placing(data, t);
    // One value a place is met anywhere over its name.
    const alone = data.bars || data.groups !== undefined;
    let [found, least] = [-1, alone ? this.barWidth(data, t) / 2 + 2 : REACH];
    for (let row = 0; row < data.x.values.length; row++) {
      const [px, py] = place(row);
      const distance = alone ? Math.abs(px - x) : Math.hypot(px - x, py - y);
      if (distance <= least) [found, least] = [row, distance];
    }
    return found;
  }

  protected override paint(context: CanvasRenderingContext2D, colours: Colours, _: BlockView, t: Transform): void {
    const data = this.data();
    context.font = FONT;
    if (data === null || data.x.values.length === 0) return;
    const area = this.area(data);
    this.paintAxes(context, colours, data, t, area);
    this.paintLegend(context, colours, data);
    within(context, area, () => this.paintValues(context, colours, data, t, area));
    if (this.outline?.to != null) {
      const [[x0, y0], [x1, y1]] = [this.outline.from, this.outline.to];
      context.strokeStyle = colours.accent;
      context.setLineDash([5, 3]);
      context.strokeRect(x0, y0, x1 - x0, y1 - y0);
      context.setLineDash([]);
    }
  }

  private paintAxes(context: CanvasRenderingContext2D, colours: Colours, data: PlotData, t: Transform, { left, top, width, height }: Rect): void {
    const at = this.scaling(data, t);
    const seen = this.seen(data, t);
    const { names } = data.x;
    const { upright } = this.laid(data);
    const across = names === undefined ? ticksBetween(seen.x, width / APART.x) : namesWritten(seen.x, names, at(1, 0)[0] - at(0, 0)[0]);
    const isLogarithmic = data.y.logarithmic === true;
    const most = Math.max(LEAST_TICKS, height / APART.y);
    const up = isLogarithmic ? ticksOfPowers(seen.y, most) : ticksBetween(seen.y, most);
    const digitsX = decimalsOf(across);
    // Of ticks of powers each has the decimals that it needs.
    const digitsOf = (tick: number) => (isLogarithmic ? (String(tick).split('.')[1]?.length ?? 0) : decimalsOf(up));
    context.strokeStyle = colours.line;
    context.fillStyle = colours.muted;
    context.lineWidth = 1;
    context.textBaseline = 'middle';
    for (const tick of up) {
      const [, y] = at(0, tick);
      line(context, [left, y], [left + width, y]);
      context.textAlign = 'end';
      context.fillText(fixed(tick, digitsOf(tick)), left - 6, y);
    }
    for (const tick of across) {
      const [x] = at(tick, 0);
      if (names === undefined) line(context, [x, top], [x, top + height]);
      if (upright) upwards(context, shortened(context, names?.[tick] ?? '', UPRIGHT_MOST), x, top + height + 6);
      else {
        context.textAlign = 'center';
        context.fillText(names?.[tick] ?? fixed(tick, digitsX), x, top + height + 10);
      }
    }
    context.strokeStyle = colours.muted;
    if (data.groups !== undefined) within(context, { left, top, width, height }, () => line(context, [left, at(0, 0)[1]], [left + width, at(0, 0)[1]]));
    context.strokeRect(left, top, width, height);
    context.fillStyle = colours.text;
    context.textAlign = 'center';
    const [titleX, titleY] = [titleOf(data.x), titleOf(data.y)];
    const x = titleWithin(context.measureText(titleX).width, left + width / 2, this.layers.width);
    context.fillText(titleX, x.middle, this.layers.height - ROOM.bottom + 28, x.most);
    const y = titleWithin(context.measureText(titleY).width, top + height / 2, this.layers.height);
    context.save();
    context.translate(12, y.middle);
    context.rotate(-Math.PI / 2);
    context.fillText(titleY, 0, 0, y.most);
    context.restore();
  }

  /** What the marks and the whiskers are. */
  private paintLegend(context: CanvasRenderingContext2D, colours: Colours, data: PlotData): void {
    const { groups } = data;
    if (groups === undefined) return;
    for (const { text, group, x, line: below } of this.laid(data).legend) {
      const [middle, y] = [x + 5, ROOM.top / 2 + 4 + below * LEGEND.line];
      const mark = groups.kinds[group]?.mark;
      if (mark === undefined) paintWhisker(context, colours.text, middle, y - 6, y + 6);
      else paintMark(context, mark, colourOf(mark, colours), colours.surface, middle, y, MARK);
      context.fillStyle = colours.text;
      context.textAlign = 'left';
      context.textBaseline = 'middle';
      context.fillText(asSentence(text), x + LEGEND.mark, y);
    }
  }

  private paintValues(context: CanvasRenderingContext2D, colours: Colours, data: PlotData, t: Transform, area: Rect): void {
    const { chosen, pointed } = this.store.state.selection;
    const place = this.placing(data, t);
    const rows = data.x.values.length;
    const [isChosen, isPointed] = [data.chosen(chosen), data.chosen(pointed)];
    const width = this.barWidth(data, t);
    const base = data.bars ? this.base(data, t) : 0;
    const half = rows <= FEW ? 2.5 : 1.5;
    const { groups, whiskers } = data;
    const at = this.scaling(data, t);
    const draw = (row: number, larger: number, colour?: string) => {
      const [x, y] = place(row);
      if (groups !== undefined) {
        const mark = groups.kinds[groups.of(row)]?.mark ?? 'square';
        const own = colour ?? colourOf(mark, colours);
        const [from, to] = [whiskers?.from[row] ?? NaN, whiskers?.to[row] ?? NaN];
        if (!Number.isNaN(from)) paintWhisker(context, own, x, at(0, from)[1], at(0, to)[1]);
        paintMark(context, mark, own, colours.surface, x, y, MARK + larger);
      } else if (data.bars) context.fillRect(x - width / 2, Math.min(y, base), width, Math.max(1, Math.abs(base - y)));
      else if (x > area.left - 4 && y > area.top - 4 && x < area.left + area.width + 4 && y < area.top + area.height + 4)
        context.fillRect(x - half - larger, y - half - larger, 2 * (half + larger), 2 * (half + larger));
    };
    if (data.equal === true) this.paintEqual(context, colours, data, t);
    context.fillStyle = colours.bars;
    for (let row = 0; row < rows; row++) draw(row, 0);
    context.fillStyle = colours.problem;
    let under = -1;
    for (let row = 0; row < rows; row++) {
      if (chosen !== null && isChosen(row)) draw(row, 1, colours.problem);
      if (under < 0 && pointed !== null && isPointed(row)) under = row;
    }
    context.strokeStyle = colours.problem;
    context.lineWidth = 2;
    const [ux, uy] = place(under);
    if (under >= 0 && data.bars) context.strokeRect(ux - width / 2, Math.min(uy, base), width, Math.abs(base - uy));
    else if (under >= 0) context.strokeRect(ux - 5, uy - 5, 10, 10);
    if (under >= 0) this.paintValue(context, colours, data, under, place(under), area);
  }

  /** Where both values are the same. */
  private paintEqual(context: CanvasRenderingContext2D, colours: Colours, data: PlotData, t: Transform): void {
    const at = this.scaling(data, t);
    const [from, to] = endsOf(data, this.layers.width, this.layers.height).x;
    context.strokeStyle = colours.text;
    context.lineWidth = 1;
    line(context, at(from, from), at(to, to));
  }

  /** What the value under the pointer is. */
  private paintValue(context: CanvasRenderingContext2D, colours: Colours, { x, y, said }: PlotData, row: number, [px, py]: [number, number], area: Rect): void {
    const value = ({ unit, values, names }: PlotData['x']) => {
      const name = names?.[Math.round(values[row] ?? NaN)];
      return name === undefined ? withUnit(figure(values[row] ?? NaN), unit) : asFigure(name);
    };
    const text = asSentence(said === undefined ? `${value(x)}: ${value(y)}` : said(row));
    const wide = context.measureText(text).width + 12;
    // One that is longer than the picture begins at its edge.
    const left = Math.max(Math.min(area.left, this.layers.width - wide), 0, Math.min(px + 8, area.left + area.width - wide));
    const top = Math.max(area.top, Math.min(py - 24, area.top + area.height - 20));
    context.fillStyle = colours.surface;
    context.fillRect(left, top, wide, 18);
    context.strokeStyle = colours.line;
    context.lineWidth = 1;
    context.strokeRect(left, top, wide, 18);
    context.fillStyle = colours.text;
    context.textAlign = 'start';
    context.textBaseline = 'middle';
    context.fillText(text, left + 6, top + 9);
  }
}

type Mark = NonNullable<PlotData['groups']>['kinds'][number]['mark'];

function colourOf(mark: Mark, colours: Colours): string {
  return mark === 'square' ? colours.text : colours.accent;
}

/** `half`: half its width. An outline is the triangle without what is in it. */
function paintMark(context: CanvasRenderingContext2D, mark: Mark, colour: string, ground: string, x: number, y: number, half: number): void {
  context.beginPath();
  if (mark === 'square') context.rect(x - half, y - half, 2 * half, 2 * half);
  else {
    context.moveTo(x, y - half - 1);
    context.lineTo(x + half + 1, y + half);
    context.lineTo(x - half - 1, y + half);
    context.closePath();
  }
  context.fillStyle = mark === 'outline' ? ground : colour;
  context.fill();
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.stroke();
}

function paintWhisker(context: CanvasRenderingContext2D, colour: string, x: number, from: number, to: number): void {
  context.strokeStyle = colour;
  context.lineWidth = 1;
  line(context, [x, from], [x, to]);
  for (const end of [from, to]) line(context, [x - CAP, end], [x + CAP, end]);
}

/** A text that reads upwards and ends below a place. */
function upwards(context: CanvasRenderingContext2D, text: string, x: number, y: number): void {
  context.save();
  context.translate(x, y);
  context.rotate(-Math.PI / 2);
  context.textAlign = 'right';
  context.fillText(text, 0, 0);
  context.restore();
}

let ruler: CanvasRenderingContext2D | null = null;

/** How long a text of the plot is, CSS px. */
function measured(text: string): number {
  ruler ??= document.createElement('canvas').getContext('2d');
  if (ruler === null) return 0;
  ruler.font = FONT;
  return ruler.measureText(text).width;
}

/** Names are measured once, not whenever the pointer moves. */
const laidWithin = remember((data: PlotData, width: number) => laidOut(data, width, measured));

function line(context: CanvasRenderingContext2D, from: readonly [number, number], to: readonly [number, number]): void {
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
}

/** Whole numbers as they are, others to the third decimal, or to the third digit that counts. */
function figure(value: number): string {
  if (Number.isInteger(value)) return fixed(value, 0);
  return fixed(value, Math.min(7, Math.max(3, 2 - Math.floor(Math.log10(Math.abs(value))))));
}

/** A text that is no longer than it may be: names of images differ at their ends. */
function shortened(context: CanvasRenderingContext2D, text: string, most: number): string {
  if (context.measureText(text).width <= most) return text;
  let from = 1;
  while (from < text.length - 1 && context.measureText(`…${text.slice(from)}`).width > most) from += 1;
  return `…${text.slice(from)}`;
}
