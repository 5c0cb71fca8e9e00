/** Light, dark, or as the system has it. */

const NEXT: Readonly<Record<string, string>> = { auto: 'light', light: 'dark', dark: 'auto' };
const NAME = 'tiepoint-theme';

/** Storage may be switched off, or absent on file://: the choice then lasts as long as the page. */
function remembered(): string | null {
  try {
    return localStorage.getItem(NAME);
  } catch {
    return null;
  }
}

function keep(theme: string): void {
  try {
    localStorage.setItem(NAME, theme);
  } catch {
    // See `remembered`.
  }
}

export function mountTheme(button: HTMLElement): void {
  const show = (theme: string) => {
    document.documentElement.dataset.theme = theme;
    button.textContent = { auto: 'Theme: auto', light: 'Theme: light', dark: 'Theme: dark' }[theme] ?? 'Theme';
  };
  const saved = remembered();
  show(saved !== null && saved in NEXT ? saved : 'auto');
  button.addEventListener('click', () => {
    const theme = NEXT[document.documentElement.dataset.theme ?? 'auto'] ?? 'auto';
    show(theme);
    keep(theme);
  });
}
