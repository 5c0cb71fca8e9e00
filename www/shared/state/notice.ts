/** What the status line says of what a user did. */
export interface Notice {
  kind: 'info' | 'busy' | 'problem';
  text: string;
  /** It is said after what the line says anyway, not in its place. */
  beside?: boolean;
  /** It is said while a run goes on, and no longer. */
  passing?: boolean;
}
