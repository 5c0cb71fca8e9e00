/** What the browser remembers beside its storage: the project of this tab, and how often the page broke off with one. */

/** The project of this tab, which a reload opens again. */
const TAB_PROJECT = 'tiepoint-project';
/** How often in a row the page broke off with a project; then it is opened only when the user asks. */
const BROKE_OFF = 'tiepoint-broke-off';
const MOST_BREAKS = 2;

/** Runs what may be forbidden to a page: its storage of words. */
function allowed<T>(action: () => T, otherwise: T): T {
  try {
    return action();
  } catch {
    return otherwise;
  }
}

export const rememberedProject = () => allowed(() => sessionStorage.getItem(TAB_PROJECT), null);
export const rememberProject = (id: string) => allowed(() => sessionStorage.setItem(TAB_PROJECT, id), undefined);

/** How often in a row the page broke off with this project. */
function breaks(id: string): number {
  const [project, count] = (allowed(() => localStorage.getItem(BROKE_OFF), null) ?? '').split(' ');
  return project === id ? Number(count) || 0 : 0;
}

export const countBreak = (id: string) => allowed(() => localStorage.setItem(BROKE_OFF, `${id} ${String(breaks(id) + 1)}`), undefined);
export const forgetBreaks = () => allowed(() => localStorage.removeItem(BROKE_OFF), undefined);

/** Whether the page broke off with this project so often that only the user may open it. */
export const breaksOff = (project: string): boolean => breaks(project) >= MOST_BREAKS;
