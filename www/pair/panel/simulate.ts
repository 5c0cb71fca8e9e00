/** A flight to simulate: presets, a control for each of its parameters, and a small picture of the pair that follows every change. */
import { whenQuiet } from '../../shared/engine/breath';
import { problemOfFlight } from '../engine/checks';
import type { Engine } from '../engine/engine';
import { CallError, Cancelled } from '../../shared/engine/client';
import type { Catalogue, Flight, SampleImage } from '../../shared/crate';
import { readable } from '../../shared/text/names';
import type { Store } from '../state/store';
import { button, h } from '../../shared/panel/dom';
import { makeSections } from '../../shared/panel/sections';
import type { Sections } from '../../shared/panel/sections';
import { withSetting } from '../../shared/panel/settings';
import { say } from '../../shared/text/words';

/** Longest side of the preview's images, in px. */
const PREVIEW_SIDE = 240;
/** Quiet time after a change before the preview is rendered, in ms. */
const DEBOUNCE_MS = 120;

type Field = keyof Flight;

const PRESETS: Readonly<Record<string, string>> = {
  sample: say('sample-the-built-in-pair'),
  paper: say('paper-its-geometry-and-angles'),
  hard: say('hard-high-relief-blur-noise'),
  lively: say('lively-river-traffic-grain-haze'),
};

export function mountSimulate(host: HTMLElement, store: Store, engine: Engine, render: (name: string, flight: Flight) => void): void {
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue !== null) whenQuiet(() => new SimulatePanel(host, store, engine, catalogue, render));
  });
}

class SimulatePanel {
  private readonly preset = h('select', { id: 'flight-preset', testid: 'flight-preset' });
  private readonly problem = h('p', { class: 'field-problem', role: 'alert', testid: 'flight-problem' });
  private readonly pictures = [h('canvas', { class: 'preview', testid: 'preview-left' }), h('canvas', { class: 'preview', testid: 'preview-right' })] as const;
  private readonly sections: Sections;
  private timer: number | undefined;
  private rendering = false;
  private shown: Flight | null = null;

  constructor(
    private readonly host: HTMLElement,
    private readonly store: Store,
    private readonly engine: Engine,
    private readonly catalogue: Catalogue,
    render: (name: string, flight: Flight) => void,
  ) {
    for (const { name } of catalogue.flights) this.preset.append(new Option(PRESETS[name] ?? name, name));
    this.preset.addEventListener('change', () => store.dispatch({ type: 'flight', flight: this.standard() }));
    this.sections = makeSections(catalogue.flightParameters, {
      change: (key, value) => {
        const { flight } = store.state;
        if (flight !== null) store.dispatch({ type: 'flight', flight: withSetting(flight, key, value) });
      },
      defaults: () => this.standard(),
    });
    const go = button(say('render-this-pair'), 'render-flight', () => {
      const { flight } = store.state;
      if (flight !== null) render(this.preset.value, flight);
    });
    go.className = 'primary';
    const another = button(
      say('another-town'),
      'flight-reseed',
      () => {
        const { flight } = store.state;
        if (flight !== null) store.dispatch({ type: 'flight', flight: { ...flight, seed: (flight.seed + 1) % 2 ** 32 } });
      },
      say('the-next-seed'),
    );
    host.append(
      h('p', { class: 'note' }, say('a-flight-over-a-synthetic')),
      h('div', { class: 'control' }, h('label', { for: 'flight-preset' }, say('preset')), this.preset),
      h('div', { class: 'previews' }, ...this.pictures),
      this.problem,
      h('div', { class: 'buttons' }, go, another),
      ...this.sections.elements,
    );
    store.watch(['flight'], ([flight]) => {
      if (flight === null) return;
      this.sections.show(flight);
      this.later();
    });
    // Nothing is rendered for a panel that is not looked at.
    new IntersectionObserver(() => this.later()).observe(host);
  }

  private standard(): Flight {
    const found = this.catalogue.flights.find(({ name }) => name === this.preset.value) ?? this.catalogue.flights[0];
    if (found === undefined) throw new Error('the program names no flight');
    return found.flight;
  }

  private later(): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.preview(), DEBOUNCE_MS);
  }

  /** Renders the newest flight, one rendering at a time. */
  private async preview(): Promise<void> {
    const { flight } = this.store.state;
    if (this.rendering || flight === null || flight === this.shown || this.host.offsetParent === null) return;
    this.shown = flight;
    const problem = problemOfFlight(flight);
    this.tell(problem?.text ?? null);
    if (problem !== null) {
      // The preview's own problems would be those of its coarser pixels.
      this.sections.controls.find(({ parameter }) => parameter.key === problem.field)?.refuse(`${readable(this.catalogue, problem.text)}.`);
      return;
    }
    this.rendering = true;
    try {
      const { left, right } = await this.engine.client('preview').call('simulate', reduced(flight, this.catalogue));
      paint(this.pictures[0], left, say('preview-of-the-left-image'));
      paint(this.pictures[1], right, say('preview-of-the-right-image'));
    } catch (error) {
      if (error instanceof CallError) this.tell(say('no-preview', { message: error.message }));
      else if (!(error instanceof Cancelled)) throw error;
    } finally {
      this.rendering = false;
    }
    if (this.store.state.flight !== flight) this.later();
  }

  private tell(problem: string | null): void {
    this.problem.textContent = problem === null ? '' : `${readable(this.catalogue, problem)}.`;
  }
}

/** The same flight with coarser pixels: as coarse as the preview is small, within what the crate flies. */
function reduced(flight: Flight, { flightParameters }: Catalogue): Flight {
  const { pixel_mm: pixel, width_px: width, height_px: height } = flight;
  const range = (field: Field) => {
    const parameter = flightParameters.find(({ key }) => key === `flight.${field}`);
    return parameter?.kind === 'integer' || parameter?.kind === 'real' ? parameter : { min: 1, max: Infinity };
  };
  const thinnest = Math.min(width / range('width_px').min, height / range('height_px').min);
  const factor = Math.max(1, Math.floor(Math.min(Math.ceil(Math.max(width, height) / PREVIEW_SIDE), range('pixel_mm').max / pixel, thinnest)));
  return { ...flight, pixel_mm: pixel * factor, width_px: Math.floor(width / factor), height_px: Math.floor(height / factor) };
}

function paint(canvas: HTMLCanvasElement, { width, height, grey }: SampleImage, words: string): void {
  canvas.width = width;
  canvas.height = height;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', words);
  const pixels = new ImageData(width, height);
  grey.forEach((value, i) => {
    pixels.data.fill(value, 4 * i, 4 * i + 3);
    pixels.data[4 * i + 3] = 255;
  });
  canvas.getContext('2d')?.putImageData(pixels, 0, 0);
}
