/** A window as enlarged pixels, with the centroid and axis of its moments where these were compared. */
import type { WindowReport } from '../../shared/crate';
import { h } from '../../shared/panel/dom';
import { say } from '../../shared/text/words';

const SIDE = 132;

/** The pixels of the window about the pixel `col`, `row`, the ones outside a circular window darkened; the ring marks the centroid, the line the axis. */
export function windowPicture(report: WindowReport, col: number, row: number, axis: boolean): HTMLCanvasElement {
  const { side } = report;
  const canvas = h('canvas', { class: 'window', role: 'img', aria: { label: say('px-window-enlarged', { side }) } });
  const pixel = Math.max(2, Math.floor((2 * SIDE) / side));
  canvas.width = side * pixel;
  canvas.height = side * pixel;
  const context = canvas.getContext('2d');
  if (context === null) return canvas;
  for (let i = 0; i < side * side; i++) {
    const grey = String(report.grey[i] ?? 0);
    context.fillStyle = report.mask[i] === false ? `rgb(${grey} ${grey} ${grey} / 0.25)` : `rgb(${grey} ${grey} ${grey})`;
    context.fillRect((i % side) * pixel, Math.floor(i / side) * pixel, pixel, pixel);
  }
  if (axis) drawAxis(context, report, [report.centroid_px[0] - col - 0.5, report.centroid_px[1] - row - 0.5], pixel);
  return canvas;
}

function drawAxis(context: CanvasRenderingContext2D, report: WindowReport, [dx, dy]: [number, number], pixel: number): void {
  const middle = (report.side * pixel) / 2;
  const x = middle + dx * pixel;
  const y = middle + dy * pixel;
  const angle = (report.axis_angle_deg * Math.PI) / 180;
  const reach = 0.45 * report.side * pixel;
  context.strokeStyle = '#ffd400';
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(x - reach * Math.cos(angle), y - reach * Math.sin(angle));
  context.lineTo(x + reach * Math.cos(angle), y + reach * Math.sin(angle));
  context.stroke();
  context.beginPath();
  context.arc(x, y, 5, 0, 2 * Math.PI);
  context.stroke();
}
