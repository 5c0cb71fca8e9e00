/** What the status line says of what a user did. */
export interface Notice {
  kind: 'info' | 'busy' | 'problem';
  text: string;
}
