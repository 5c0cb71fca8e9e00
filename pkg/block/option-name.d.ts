/** What the command calls the option of a parameter, without the dashes, as its messages name it; a flag that switches something off has `no-` before it. */
export function optionName(parameter: { key: string; named: string }): string;
