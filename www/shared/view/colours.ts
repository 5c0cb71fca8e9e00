/** The colours of the page's theme, for canvases. */

const NAMES = ['text', 'muted', 'line', 'accent', 'problem', 'good', 'bars', 'ground', 'surface'] as const;

export type Colours = Readonly<Record<(typeof NAMES)[number], string>>;

let known: Colours | null = null;

/** The colours as they are now. Custom properties hold both themes' colours; an element's own colour is the one that counts. */
export function themeColours(): Colours {
  known ??= readColours();
  return known;
}

function readColours(): Colours {
  const probe = document.createElement('span');
  // Where the system gives the colours of texts, what is drawn is still told apart by its own.
  probe.style.setProperty('forced-color-adjust', 'none');
  document.body.append(probe);
  const colours = Object.fromEntries(
    NAMES.map((name) => {
      probe.style.color = `var(--${name})`;
      return [name, getComputedStyle(probe).color];
    }),
  );
  probe.remove();
  return colours as Colours;
}

/** Calls back when the theme was changed, by the user or by the system. */
export function onRecolour(callback: () => void): void {
  const changed = () => {
    known = null;
    callback();
  };
  new MutationObserver(changed).observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', changed);
  matchMedia('(forced-colors: active)').addEventListener('change', changed);
}
