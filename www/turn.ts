/** What runs before anything is drawn: it turns the document the way of its language. It is small, since it stands in the page itself. */
import { LANGUAGE, LANGUAGES } from './shared/text/language';

const root = document.documentElement;
root.lang = LANGUAGE;
root.dir = LANGUAGES[LANGUAGE].direction;
// What the document holds is English: in another language it is seen once it is said, so that no text moves another.
if (LANGUAGE !== 'en') root.dataset.unsaid = '';
