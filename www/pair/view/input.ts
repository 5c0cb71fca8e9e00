/** Pointer, wheel, touch and keys on the canvas. */
import { otherSide } from '../state/state';
import type { Side } from '../state/state';
import type { Store } from '../state/store';
import type { Navigator } from './navigate';
import { paneAt } from './scene';
import type { View } from './view';

/** Movement below which a press is a click, in CSS px. */
const CLICK_SLACK = 5;
const KEY_PAN = 60;
const KEY_ZOOM = 1.25;

interface Press {
  x: number;
  y: number;
  startX: number;
  startY: number;
}

export class Input {
  private readonly presses = new Map<number, Press>();
  private side: Side = 'left';
  private clicked = false;

  constructor(private readonly view: View, private readonly store: Store, private readonly navigator: Navigator) {
    const { host } = view;
    host.addEventListener('pointerdown', (event) => { this.down(event); });
    host.addEventListener('pointermove', (event) => { this.move(event); });
    host.addEventListener('pointerup', (event) => { this.up(event); });
    host.addEventListener('pointercancel', (event) => { this.presses.delete(event.pointerId); });
    host.addEventListener('pointerleave', () => { view.point(null); });
    host.addEventListener('wheel', (event) => { this.wheel(event); }, { passive: false });
    // The bar of the view belongs to it: after a press there the keys go on.
    (host.closest('.stage') ?? host).addEventListener('keydown', (event) => { this.key(event as KeyboardEvent); });
  }

  private place(event: MouseEvent): [number, number] {
    const box = this.view.host.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || (event.target as Element).closest('button') !== null) return;
    const [x, y] = this.place(event);
    const pane = paneAt(this.view.scene(), x, y);
    if (pane === null) return;
    this.view.host.setPointerCapture(event.pointerId);
    this.clicked = this.presses.size === 0;
    this.side = pane.side;
    this.presses.set(event.pointerId, { x, y, startX: x, startY: y });
    if (this.store.state.activeSide !== pane.side) this.store.dispatch({ type: 'activeSide', side: pane.side });
  }

  private move(event: PointerEvent): void {
    const [x, y] = this.place(event);
    this.view.point([x, y]);
    const press = this.presses.get(event.pointerId);
    if (press === undefined) return;
    if (this.presses.size === 1) {
      if (this.clicked && Math.hypot(x - press.startX, y - press.startY) <= CLICK_SLACK) return;
      this.clicked = false;
      this.navigator.pan(this.side, x - press.x, y - press.y);
    } else {
      this.pinch(event.pointerId, x, y);
    }
    press.x = x;
    press.y = y;
  }

  /** Two fingers: pan by their middle, zoom by their distance. */
  private pinch(id: number, x: number, y: number): void {
    const moved = this.presses.get(id);
    const still = [...this.presses].find(([other]) => other !== id)?.[1];
    if (moved === undefined || still === undefined) return;
    const before = Math.hypot(moved.x - still.x, moved.y - still.y);
    const after = Math.hypot(x - still.x, y - still.y);
    this.navigator.pan(this.side, (x - moved.x) / 2, (y - moved.y) / 2);
    if (before > 1 && after > 1) this.navigator.zoom(this.side, after / before, (x + still.x) / 2, (y + still.y) / 2);
  }

  private up(event: PointerEvent): void {
    if (!this.presses.delete(event.pointerId) || !this.clicked) return;
    const [x, y] = this.place(event);
    this.navigator.select(this.view.hit(x, y));
  }

  private wheel(event: WheelEvent): void {
    const [x, y] = this.place(event);
    const pane = paneAt(this.view.scene(), x, y);
    if (pane?.picture == null) return;
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 24 : 1;
    // A pinch on a touch pad comes as a wheel event with Ctrl and small steps.
    const rate = event.ctrlKey ? 0.01 : 0.0016;
    this.navigator.zoom(pane.side, Math.exp(-rate * lines * event.deltaY), x, y);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || (event.target as Element).closest('input, select, .welcome') !== null) return;
    if (this.command(event.key, event.shiftKey ? 4 : 1)) event.preventDefault();
  }

  /** Runs the command of a key; false where it has none. */
  private command(key: string, speed: number): boolean {
    const { state } = this.store;
    const side = state.activeSide;
    const display = state.display;
    switch (key) {
      case 'ArrowLeft': this.navigator.pan(side, speed * KEY_PAN, 0); return true;
      case 'ArrowRight': this.navigator.pan(side, -speed * KEY_PAN, 0); return true;
      case 'ArrowUp': this.navigator.pan(side, 0, speed * KEY_PAN); return true;
      case 'ArrowDown': this.navigator.pan(side, 0, -speed * KEY_PAN); return true;
      case '+': case '=': this.navigator.zoomMiddle(KEY_ZOOM); return true;
      case '-': case '_': this.navigator.zoomMiddle(1 / KEY_ZOOM); return true;
      case '0': this.navigator.fit(); return true;
      case '1': this.navigator.actualSize(); return true;
      case 'n': case 'N': this.navigator.step(1); return true;
      case 'p': case 'P': this.navigator.step(-1); return true;
      case 'o': case 'O': this.store.dispatch({ type: 'activeSide', side: otherSide(side) }); return true;
      case 'l': case 'L': this.store.dispatch({ type: 'display', display: { linked: !display.linked } }); return true;
      case 'm': case 'M': this.store.dispatch({ type: 'display', display: { magnifier: !display.magnifier } }); return true;
      case 'Escape': this.navigator.select(null); return true;
      default: return false;
    }
  }
}
