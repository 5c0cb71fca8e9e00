/** What keys do. Each is declared once: its key runs it, the list of keys names it, and who looks for an action finds it. */
export interface Command {
  /** As browsers name them; a letter stands for itself with and without Shift. */
  keys: readonly string[];
  does: string;
  run: (shift: boolean) => void;
  /** Whether it can be run now; always where it is left out. */
  can?: () => boolean;
  /** What it would do nothing without, as something that is chosen; empty where that is there. */
  lacks?: () => string;
}

export interface Commands {
  /** Where the keys have to be pressed. */
  where: string;
  /** What has them; they can be run while it is seen. */
  host: Element;
  list: readonly Command[];
  /** What those lack that cannot be run, where they do not say it themselves. */
  lacks?: string;
}

const known: Commands[] = [];

/** All that was declared. */
export const declared = (): readonly Commands[] => known;

/** Declares commands; gives what runs the one of a key, false where there is none now. */
export function declare(commands: Commands): (key: string, shift: boolean) => boolean {
  known.push(commands);
  return (key, shift) => {
    const name = key.length === 1 ? key.toLowerCase() : key;
    const command = commands.list.find(({ keys, can }) => keys.includes(name) && can?.() !== false);
    command?.run(shift);
    return command !== undefined;
  };
}

const SIGNS: Readonly<Record<string, string>> = {
  Delete: 'Del',
  Escape: 'Esc',
  PageDown: 'Page Down',
  PageUp: 'Page Up',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  '-': '−',
};

/** How a key is written. */
export const keyText = (key: string): string => SIGNS[key] ?? (key.length === 1 ? key.toUpperCase() : key);
