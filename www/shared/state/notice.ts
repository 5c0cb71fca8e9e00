/** What the status line says of what a user did. */
export interface Notice {
  kind: 'info' | 'busy' | 'problem';
  text: string;
  /** It is said after what the line says anyway, not in its place. */
  beside?: boolean;
  /** It is said while a run goes on, and no longer. */
  passing?: boolean;
  /** It is said beside the button of this `data-testid`, and the line says what it says anyway. */
  near?: string;
  /** It is a question, in place of the answer until something is done: the first of these is what most users want. */
  choices?: readonly Choice[];
}

/** What can be answered. */
export interface Choice {
  text: string;
  act: () => void;
}

/** What the line says of it: nothing where it is said beside a button. */
export function ofLine(notice: Notice | null): Notice | null {
  return notice?.near === undefined ? notice : null;
}
