/** Light, dark, or as the system has it. */
import { keepChoice, keptChoice } from '../choices';
import { say } from '../text/words';

const NEXT: Readonly<Record<string, string>> = { auto: 'light', light: 'dark', dark: 'auto' };
const NAME = 'tiepoint-theme';

export function mountTheme(button: HTMLElement): void {
  const show = (theme: string) => {
    document.documentElement.dataset.theme = theme;
    button.textContent = { auto: say('theme-auto'), light: say('theme-light'), dark: say('theme-dark') }[theme] ?? say('theme');
  };
  const saved = keptChoice(NAME);
  show(saved !== null && saved in NEXT ? saved : 'auto');
  button.addEventListener('click', () => {
    const theme = NEXT[document.documentElement.dataset.theme ?? 'auto'] ?? 'auto';
    show(theme);
    keepChoice(NAME, theme);
  });
}
