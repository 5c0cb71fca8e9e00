// @ts-check

/** What the command calls the option of a parameter, without the dashes, as its messages name it; a flag that switches something off has `no-` before it.  @param {{ key: string, named: string }} parameter */
export const optionName = ({ key, named }) => named || key.replace(/^.*\./, '').replaceAll('_', '-');
