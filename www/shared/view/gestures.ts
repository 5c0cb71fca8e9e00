/** Pointer, wheel, touch and keys: every canvas of the page is moved in the same way. */
import { say } from '../text/words';

/** What gestures move. `T` names what lies at a place: one of two images, or the one plan. */
export interface Movable<T> {
  /** What is moved at a place of the host (CSS px); null where nothing is. */
  at: (x: number, y: number) => T | null;
  /** What keys move; null where nothing is. */
  focused: () => T | null;
  /** Moves the content by CSS px. */
  pan: (target: T, dx: number, dy: number) => void;
  /** Enlarges about a place. */
  zoom: (target: T, factor: number, x: number, y: number) => void;
  /** Enlarges about what is looked at: the middle, or what is chosen. */
  zoomMiddle: (factor: number) => void;
  fit: () => void;
  /** A press begins on a target. */
  grabbed?: (target: T) => void;
  /** A press ended where it began; `more`: with Ctrl or Cmd. */
  pressed: (x: number, y: number, more: boolean) => void;
  /** Whether a drag that begins now draws a rectangle in place of moving; Shift asks for it too. */
  encloses?: (shift: boolean) => boolean;
  /** A rectangle is drawn from one place to another; `ended`: it stands. Null where it was given up. `path`: all places on the way, for who draws freely. */
  enclosed?: (target: T, from: [number, number], to: [number, number] | null, ended: boolean, path: readonly [number, number][]) => void;
  /** The pointer is at a place, or has left. */
  pointed: (at: [number, number] | null, dragging: boolean) => void;
  /** Runs a command of the picture's own; false where the key has none. */
  command: (key: string, shift: boolean) => boolean;
}

/** Movement below which a press is a click, CSS px. */
const CLICK_SLACK = 5;
const KEY_PAN = 60;
const KEY_ZOOM = 1.25;
/** Wheels that count in lines scroll about so many px each. */
const LINE_PX = 24;
/** Natural logarithm of the enlargement a px of wheel; a pinch on a touch pad comes as a wheel event with Ctrl and small steps. */
const WHEEL_RATE = 0.0016;
const PINCH_RATE = 0.01;

/** What keys do in every picture: the same in all of them. */
interface Move {
  keys: readonly string[];
  does: string;
  run: <T>(movable: Movable<T>, far: boolean) => void;
}

const pan =
  (dx: number, dy: number) =>
  <T>(movable: Movable<T>, far: boolean): void => {
    const target = movable.focused();
    const step = KEY_PAN * (far ? 4 : 1);
    if (target !== null) movable.pan(target, dx * step, dy * step);
  };

export const MOVES: readonly Move[] = [
  { keys: ['ArrowLeft'], does: say('moves-the-picture-with-shift'), run: pan(1, 0) },
  { keys: ['ArrowRight'], does: say('moves-the-picture-with-shift'), run: pan(-1, 0) },
  { keys: ['ArrowUp'], does: say('moves-the-picture-with-shift'), run: pan(0, 1) },
  { keys: ['ArrowDown'], does: say('moves-the-picture-with-shift'), run: pan(0, -1) },
  { keys: ['+', '='], does: say('key-enlarges'), run: (movable) => movable.zoomMiddle(KEY_ZOOM) },
  { keys: ['-', '_'], does: say('makes-smaller'), run: (movable) => movable.zoomMiddle(1 / KEY_ZOOM) },
  { keys: ['0'], does: say('shows-the-whole-picture'), run: (movable) => movable.fit() },
];

interface Press {
  x: number;
  y: number;
  startX: number;
  startY: number;
}

/** Listens on a host, and for keys on it or on a larger element that belongs to it: keys that nothing has are the browser's, as arrows that scroll the page. */
export function listen<T>(host: HTMLElement, movable: Movable<T>, keyHost: HTMLElement = host): void {
  new Gestures(host, movable, keyHost);
}

/** Listens for the keys of commands where there are no gestures. */
export function listenKeys(host: HTMLElement, command: (key: string, shift: boolean) => boolean): void {
  host.addEventListener('keydown', (event) => {
    // A picture in it has done what the key says there.
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || (event.target as Element).closest('input, select') !== null) return;
    if (command(event.key, event.shiftKey)) event.preventDefault();
  });
}

class Gestures<T> {
  private readonly presses = new Map<number, Press>();
  private target: T | null = null;
  private clicked = false;
  private encloses = false;
  /** Of what is being enclosed. */
  private path: [number, number][] = [];

  constructor(
    private readonly host: HTMLElement,
    private readonly movable: Movable<T>,
    keyHost: HTMLElement,
  ) {
    host.addEventListener('pointerdown', (event) => this.down(event));
    host.addEventListener('pointermove', (event) => this.move(event));
    host.addEventListener('pointerup', (event) => this.up(event));
    host.addEventListener('pointercancel', (event) => this.leave(event));
    host.addEventListener('pointerleave', () => movable.pointed(null, false));
    host.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    keyHost.addEventListener('keydown', (event) => this.key(event));
  }

  private place(event: MouseEvent): [number, number] {
    const box = this.host.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || (event.target as Element).closest('button') !== null) return;
    const [x, y] = this.place(event);
    const target = this.movable.at(x, y);
    if (target === null) return;
    this.host.setPointerCapture(event.pointerId);
    this.clicked = this.presses.size === 0;
    // A second finger moves and zooms again.
    if (!this.clicked) this.giveUp();
    this.encloses = this.clicked && this.movable.encloses?.(event.shiftKey) === true;
    this.path = [[x, y]];
    this.target = target;
    this.presses.set(event.pointerId, { x, y, startX: x, startY: y });
    this.movable.grabbed?.(target);
  }

  private move(event: PointerEvent): void {
    const [x, y] = this.place(event);
    const press = this.presses.get(event.pointerId);
    this.movable.pointed([x, y], press !== undefined);
    if (press === undefined || this.target === null) return;
    if (this.clicked && Math.hypot(x - press.startX, y - press.startY) <= CLICK_SLACK) return;
    this.clicked = false;
    if (this.encloses) {
      this.path.push([x, y]);
      this.movable.enclosed?.(this.target, [press.startX, press.startY], [x, y], false, this.path);
      return;
    }
    const still = [...this.presses].find(([id]) => id !== event.pointerId)?.[1];
    if (still === undefined) this.movable.pan(this.target, x - press.x, y - press.y);
    else this.pinch(this.target, press, still, x, y);
    press.x = x;
    press.y = y;
  }

  /** Two fingers: pan by their middle, zoom by their distance. */
  private pinch(target: T, moved: Press, still: Press, x: number, y: number): void {
    const before = Math.hypot(moved.x - still.x, moved.y - still.y);
    const after = Math.hypot(x - still.x, y - still.y);
    this.movable.pan(target, (x - moved.x) / 2, (y - moved.y) / 2);
    if (before > 1 && after > 1) this.movable.zoom(target, after / before, (x + still.x) / 2, (y + still.y) / 2);
  }

  private up(event: PointerEvent): void {
    const press = this.presses.get(event.pointerId);
    if (press === undefined) return;
    this.presses.delete(event.pointerId);
    if (this.clicked) this.movable.pressed(...this.place(event), event.ctrlKey || event.metaKey);
    else if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [press.startX, press.startY], this.place(event), true, this.path);
    this.encloses = false;
  }

  private leave(event: PointerEvent): void {
    this.presses.delete(event.pointerId);
    this.giveUp();
  }

  private giveUp(): void {
    if (this.encloses && this.target !== null) this.movable.enclosed?.(this.target, [0, 0], null, false, []);
    this.encloses = false;
  }

  private wheel(event: WheelEvent): void {
    const [x, y] = this.place(event);
    const target = this.movable.at(x, y);
    if (target === null) return;
    event.preventDefault();
    const px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX * event.deltaY : event.deltaY;
    this.movable.zoom(target, Math.exp(-(event.ctrlKey ? PINCH_RATE : WHEEL_RATE) * px), x, y);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target as Element).closest('input, select, .welcome') !== null) return;
    // They press the button that has the keyboard.
    if ((event.key === 'Enter' || event.key === ' ') && (event.target as Element).closest('button') !== null) return;
    if (this.movable.command(event.key, event.shiftKey) || this.moved(event)) event.preventDefault();
  }

  private moved({ key, shiftKey }: KeyboardEvent): boolean {
    const move = MOVES.find(({ keys }) => keys.includes(key));
    move?.run(this.movable, shiftKey);
    return move !== undefined;
  }
}
