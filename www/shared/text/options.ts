/** The options of the crate in the language of the page: their labels, helps and values. */
import type { Catalogue, Parameter } from '../crate';
import { known } from './words';
import { unitText } from './units';

/** An option, with what the catalogue has of it; the rest as the crate has it. */
export function optionInLanguage<P extends Parameter>(parameter: P): P {
  const { key, label, help, absent, section, unit } = parameter;
  const name = key.replaceAll(/[._]/gu, '-');
  const own = {
    label: known(name) ?? label,
    help: known(name, 'help') ?? help,
    absent: known(name, 'absent') ?? absent,
    unit: unitText(unit),
    section: known(`section-${section.toLowerCase().replaceAll(' ', '-')}`) ?? section,
  };
  if (parameter.kind !== 'choice') return { ...parameter, ...own };
  return { ...parameter, ...own, labels: parameter.labels.map((text, i) => known(name, parameter.values[i] ?? null) ?? text) };
}

export function catalogueInLanguage(catalogue: Catalogue): Catalogue {
  const { parameters, flightParameters } = catalogue;
  return { ...catalogue, parameters: parameters.map(optionInLanguage), flightParameters: flightParameters.map(optionInLanguage) };
}
