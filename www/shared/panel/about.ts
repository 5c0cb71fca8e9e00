/** Whose work is in this program: texts alone, which are loaded when they are first asked for. */
export { CRATES, LICENCES } from 'virtual:licences';
