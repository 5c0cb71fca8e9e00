/** Light, dark, or as the system has it. */
import { keepChoice, keptChoice } from '../state/choices';

const NEXT: Readonly<Record<string, string>> = { auto: 'light', light: 'dark', dark: 'auto' };
const NAME = 'tiepoint-theme';

export function mountTheme(button: HTMLElement): void {
  const show = (theme: string) => {
    document.documentElement.dataset.theme = theme;
    button.textContent = { auto: 'Theme: auto', light: 'Theme: light', dark: 'Theme: dark' }[theme] ?? 'Theme';
  };
  const saved = keptChoice(NAME);
  show(saved !== null && saved in NEXT ? saved : 'auto');
  button.addEventListener('click', () => {
    const theme = NEXT[document.documentElement.dataset.theme ?? 'auto'] ?? 'auto';
    show(theme);
    keepChoice(NAME, theme);
  });
}
