// www/shared/choices.ts
function keptChoice(name) {
	try {
		return localStorage.getItem(name);
	} catch {
		return null;
	}
}
function keepChoice(name, value) {
	try {
		localStorage.setItem(name, value);
	} catch {}
}
// www/shared/text/language.ts
var LANGUAGES = {
	en: {
		name: "English",
		direction: "ltr"
	},
	ar: {
		name: "العربية",
		direction: "rtl"
	}
};
var NAME = "tiepoint-language";
function isLanguage(tag) {
	return typeof tag === "string" && Object.hasOwn(LANGUAGES, tag);
}
var LANGUAGE = typeof document === "undefined" ? told() : preferred(keptChoice(NAME), navigator.languages);
function namedInLanguage(worker) {
	return `${worker} ${LANGUAGE}`;
}
function told() {
	const tag = String(globalThis.name ?? "").split(" ").at(-1);
	return isLanguage(tag) ? tag : "en";
}
function preferred(chosen, liked) {
	if (isLanguage(chosen)) return chosen;
	return liked.map((tag) => tag.split("-")[0]).find(isLanguage) ?? "en";
}
function keepLanguage(language) {
	keepChoice(NAME, language);
}
// www/shared/engine/trusted.ts
function own(address) {
	const { origin, protocol } = new URL(address, location.href);
	if (origin !== location.origin && protocol !== "blob:") throw new TypeError(`${address} is no script of this page`);
	return address;
}
var policy = typeof trustedTypes === "undefined" ? void 0 : trustedTypes.createPolicy("tiepoint", { createScriptURL: own });
function scriptAddress(address) {
	return policy === void 0 ? own(address) : policy.createScriptURL(address);
}
// node_modules/@fluent/bundle/esm/types.js
var FluentType = class {
	constructor(value) {
		this.value = value;
	}
	valueOf() {
		return this.value;
	}
};
var FluentNone = class extends FluentType {
	constructor(value = "???") {
		super(value);
	}
	toString(scope) {
		return `{${this.value}}`;
	}
};
var FluentNumber = class extends FluentType {
	constructor(value, opts = {}) {
		super(value);
		this.opts = opts;
	}
	toString(scope) {
		if (scope) try {
			return scope.memoizeIntlObject(Intl.NumberFormat, this.opts).format(this.value);
		} catch (err) {
			scope.reportError(err);
		}
		return this.value.toString(10);
	}
};
var FluentDateTime = class FluentDateTime extends FluentType {
	static supportsValue(value) {
		if (typeof value === "number") return true;
		if (value instanceof Date) return true;
		if (value instanceof FluentType) return FluentDateTime.supportsValue(value.valueOf());
		if ("Temporal" in globalThis) {
			const _Temporal = globalThis.Temporal;
			if (value instanceof _Temporal.Instant || value instanceof _Temporal.PlainDateTime || value instanceof _Temporal.PlainDate || value instanceof _Temporal.PlainMonthDay || value instanceof _Temporal.PlainTime || value instanceof _Temporal.PlainYearMonth) return true;
		}
		return false;
	}
	constructor(value, opts = {}) {
		if (value instanceof FluentDateTime) {
			opts = {
				...value.opts,
				...opts
			};
			value = value.value;
		} else if (value instanceof FluentType) value = value.valueOf();
		if (typeof value === "object" && "calendarId" in value && opts.calendar === void 0) opts = {
			...opts,
			calendar: value.calendarId
		};
		super(value);
		this.opts = opts;
	}
	[Symbol.toPrimitive](hint) {
		return hint === "string" ? this.toString() : this.toNumber();
	}
	toNumber() {
		const value = this.value;
		if (typeof value === "number") return value;
		if (value instanceof Date) return value.getTime();
		if ("epochMilliseconds" in value) return value.epochMilliseconds;
		if ("toZonedDateTime" in value) return value.toZonedDateTime("UTC").epochMilliseconds;
		throw new TypeError("Unwrapping a non-number value as a number");
	}
	toString(scope) {
		if (scope) try {
			return scope.memoizeIntlObject(Intl.DateTimeFormat, this.opts).format(this.value);
		} catch (err) {
			scope.reportError(err);
		}
		if (typeof this.value === "number" || this.value instanceof Date) return new Date(this.value).toISOString();
		return this.value.toString();
	}
};
// node_modules/@fluent/bundle/esm/resolver.js
var MAX_PLACEABLES = 100;
var FSI$1 = "⁨";
var PDI$1 = "⁩";
function match(scope, selector, key) {
	if (key === selector) return true;
	if (key instanceof FluentNumber && selector instanceof FluentNumber && key.value === selector.value) return true;
	if (selector instanceof FluentNumber && typeof key === "string") {
		if (key === scope.memoizeIntlObject(Intl.PluralRules, selector.opts).select(selector.value)) return true;
	}
	return false;
}
function getDefault(scope, variants, star) {
	if (variants[star]) return resolvePattern(scope, variants[star].value);
	scope.reportError(new RangeError("No default"));
	return new FluentNone();
}
function getArguments(scope, args) {
	const positional = [];
	const named = Object.create(null);
	for (const arg of args) if (arg.type === "narg") named[arg.name] = resolveExpression(scope, arg.value);
	else positional.push(resolveExpression(scope, arg));
	return {
		positional,
		named
	};
}
function resolveExpression(scope, expr) {
	switch (expr.type) {
		case "str": return expr.value;
		case "num": return new FluentNumber(expr.value, { minimumFractionDigits: expr.precision });
		case "var": return resolveVariableReference(scope, expr);
		case "mesg": return resolveMessageReference(scope, expr);
		case "term": return resolveTermReference(scope, expr);
		case "func": return resolveFunctionReference(scope, expr);
		case "select": return resolveSelectExpression(scope, expr);
		default: return new FluentNone();
	}
}
function resolveVariableReference(scope, { name }) {
	let arg;
	if (scope.params) {
		if (Object.prototype.hasOwnProperty.call(scope.params, name)) arg = scope.params[name];
		else return new FluentNone(`$${name}`);
	} else if (scope.args && Object.prototype.hasOwnProperty.call(scope.args, name)) arg = scope.args[name];
	else {
		scope.reportError(new ReferenceError(`Unknown variable: $${name}`));
		return new FluentNone(`$${name}`);
	}
	if (arg instanceof FluentType) return arg;
	switch (typeof arg) {
		case "string": return arg;
		case "number": return new FluentNumber(arg);
		case "object": if (FluentDateTime.supportsValue(arg)) return new FluentDateTime(arg);
		default:
			scope.reportError(new TypeError(`Variable type not supported: $${name}, ${typeof arg}`));
			return new FluentNone(`$${name}`);
	}
}
function resolveMessageReference(scope, { name, attr }) {
	const message = scope.bundle._messages.get(name);
	if (!message) {
		scope.reportError(new ReferenceError(`Unknown message: ${name}`));
		return new FluentNone(name);
	}
	if (attr) {
		const attribute = message.attributes[attr];
		if (attribute) return resolvePattern(scope, attribute);
		scope.reportError(new ReferenceError(`Unknown attribute: ${attr}`));
		return new FluentNone(`${name}.${attr}`);
	}
	if (message.value) return resolvePattern(scope, message.value);
	scope.reportError(new ReferenceError(`No value: ${name}`));
	return new FluentNone(name);
}
function resolveTermReference(scope, { name, attr, args }) {
	const id = `-${name}`;
	const term = scope.bundle._terms.get(id);
	if (!term) {
		scope.reportError(new ReferenceError(`Unknown term: ${id}`));
		return new FluentNone(id);
	}
	if (attr) {
		const attribute = term.attributes[attr];
		if (attribute) {
			scope.params = getArguments(scope, args).named;
			const resolved = resolvePattern(scope, attribute);
			scope.params = null;
			return resolved;
		}
		scope.reportError(new ReferenceError(`Unknown attribute: ${attr}`));
		return new FluentNone(`${id}.${attr}`);
	}
	scope.params = getArguments(scope, args).named;
	const resolved = resolvePattern(scope, term.value);
	scope.params = null;
	return resolved;
}
function resolveFunctionReference(scope, { name, args }) {
	let func = scope.bundle._functions[name];
	if (!func) {
		scope.reportError(new ReferenceError(`Unknown function: ${name}()`));
		return new FluentNone(`${name}()`);
	}
	if (typeof func !== "function") {
		scope.reportError(new TypeError(`Function ${name}() is not callable`));
		return new FluentNone(`${name}()`);
	}
	try {
		let resolved = getArguments(scope, args);
		return func(resolved.positional, resolved.named);
	} catch (err) {
		scope.reportError(err);
		return new FluentNone(`${name}()`);
	}
}
function resolveSelectExpression(scope, { selector, variants, star }) {
	let sel = resolveExpression(scope, selector);
	if (sel instanceof FluentNone) return getDefault(scope, variants, star);
	for (const variant of variants) if (match(scope, sel, resolveExpression(scope, variant.key))) return resolvePattern(scope, variant.value);
	return getDefault(scope, variants, star);
}
function resolveComplexPattern(scope, ptn) {
	if (scope.dirty.has(ptn)) {
		scope.reportError(new RangeError("Cyclic reference"));
		return new FluentNone();
	}
	scope.dirty.add(ptn);
	const result = [];
	const useIsolating = scope.bundle._useIsolating && ptn.length > 1;
	for (const elem of ptn) {
		if (typeof elem === "string") {
			result.push(scope.bundle._transform(elem));
			continue;
		}
		scope.placeables++;
		if (scope.placeables > MAX_PLACEABLES) {
			scope.dirty.delete(ptn);
			throw new RangeError(`Too many placeables expanded: ${scope.placeables}, max allowed is ${MAX_PLACEABLES}`);
		}
		if (useIsolating) result.push(FSI$1);
		result.push(resolveExpression(scope, elem).toString(scope));
		if (useIsolating) result.push(PDI$1);
	}
	scope.dirty.delete(ptn);
	return result.join("");
}
function resolvePattern(scope, value) {
	if (typeof value === "string") return scope.bundle._transform(value);
	return resolveComplexPattern(scope, value);
}
// node_modules/@fluent/bundle/esm/scope.js
var Scope = class {
	constructor(bundle, errors, args) {
		this.dirty = new WeakSet();
		this.params = null;
		this.placeables = 0;
		this.bundle = bundle;
		this.errors = errors;
		this.args = args;
	}
	reportError(error) {
		if (!this.errors || !(error instanceof Error)) throw error;
		this.errors.push(error);
	}
	memoizeIntlObject(ctor, opts) {
		let cache = this.bundle._intls.get(ctor);
		if (!cache) {
			cache = {};
			this.bundle._intls.set(ctor, cache);
		}
		let id = JSON.stringify(opts);
		if (!cache[id]) cache[id] = new ctor(this.bundle.locales, opts);
		return cache[id];
	}
};
// node_modules/@fluent/bundle/esm/builtins.js
function values(opts, allowed) {
	const unwrapped = Object.create(null);
	for (const [name, opt] of Object.entries(opts)) if (allowed.includes(name)) unwrapped[name] = opt.valueOf();
	return unwrapped;
}
var NUMBER_ALLOWED = [
	"unitDisplay",
	"currencyDisplay",
	"useGrouping",
	"minimumIntegerDigits",
	"minimumFractionDigits",
	"maximumFractionDigits",
	"minimumSignificantDigits",
	"maximumSignificantDigits"
];
function NUMBER$1(args, opts) {
	let arg = args[0];
	if (arg instanceof FluentNone) return new FluentNone(`NUMBER(${arg.valueOf()})`);
	if (arg instanceof FluentNumber) return new FluentNumber(arg.valueOf(), {
		...arg.opts,
		...values(opts, NUMBER_ALLOWED)
	});
	if (arg instanceof FluentDateTime) return new FluentNumber(arg.toNumber(), { ...values(opts, NUMBER_ALLOWED) });
	throw new TypeError("Invalid argument to NUMBER");
}
var DATETIME_ALLOWED = [
	"dateStyle",
	"timeStyle",
	"fractionalSecondDigits",
	"dayPeriod",
	"hour12",
	"weekday",
	"era",
	"year",
	"month",
	"day",
	"hour",
	"minute",
	"second",
	"timeZoneName"
];
function DATETIME(args, opts) {
	let arg = args[0];
	if (arg instanceof FluentNone) return new FluentNone(`DATETIME(${arg.valueOf()})`);
	if (arg instanceof FluentDateTime || arg instanceof FluentNumber) return new FluentDateTime(arg, values(opts, DATETIME_ALLOWED));
	throw new TypeError("Invalid argument to DATETIME");
}
// node_modules/@fluent/bundle/esm/memoizer.js
var cache = new Map();
function getMemoizerForLocale(locales) {
	const stringLocale = Array.isArray(locales) ? locales.join(" ") : locales;
	let memoizer = cache.get(stringLocale);
	if (memoizer === void 0) {
		memoizer = new Map();
		cache.set(stringLocale, memoizer);
	}
	return memoizer;
}
// node_modules/@fluent/bundle/esm/bundle.js
var FluentBundle = class {
	constructor(locales, { functions, useIsolating = true, transform = (v) => v } = {}) {
		this._terms = new Map();
		this._messages = new Map();
		this.locales = Array.isArray(locales) ? locales : [locales];
		this._functions = {
			NUMBER: NUMBER$1,
			DATETIME,
			...functions
		};
		this._useIsolating = useIsolating;
		this._transform = transform;
		this._intls = getMemoizerForLocale(locales);
	}
	hasMessage(id) {
		return this._messages.has(id);
	}
	getMessage(id) {
		return this._messages.get(id);
	}
	addResource(res, { allowOverrides = false } = {}) {
		const errors = [];
		for (let i = 0; i < res.body.length; i++) {
			let entry = res.body[i];
			if (entry.id.startsWith("-")) {
				if (allowOverrides === false && this._terms.has(entry.id)) {
					errors.push(new Error(`Attempt to override an existing term: "${entry.id}"`));
					continue;
				}
				this._terms.set(entry.id, entry);
			} else {
				if (allowOverrides === false && this._messages.has(entry.id)) {
					errors.push(new Error(`Attempt to override an existing message: "${entry.id}"`));
					continue;
				}
				this._messages.set(entry.id, entry);
			}
		}
		return errors;
	}
	formatPattern(pattern, args = null, errors = null) {
		if (typeof pattern === "string") return this._transform(pattern);
		let scope = new Scope(this, errors, args);
		try {
			return resolveComplexPattern(scope, pattern).toString(scope);
		} catch (err) {
			if (scope.errors && err instanceof Error) {
				scope.errors.push(err);
				return new FluentNone().toString(scope);
			}
			throw err;
		}
	}
};
// node_modules/@fluent/bundle/esm/resource.js
var RE_MESSAGE_START = /^(-?[a-zA-Z][\w-]*) *= */gm;
var RE_ATTRIBUTE_START = /\.([a-zA-Z][\w-]*) *= */y;
var RE_VARIANT_START = /\*?\[/y;
var RE_NUMBER_LITERAL = /(-?[0-9]+(?:\.([0-9]+))?)/y;
var RE_IDENTIFIER = /([a-zA-Z][\w-]*)/y;
var RE_REFERENCE = /([$-])?([a-zA-Z][\w-]*)(?:\.([a-zA-Z][\w-]*))?/y;
var RE_FUNCTION_NAME = /^[A-Z][A-Z0-9_-]*$/;
var RE_TEXT_RUN = /([^{}\n\r]+)/y;
var RE_STRING_RUN = /([^\\"\n\r]*)/y;
var RE_STRING_ESCAPE = /\\([\\"])/y;
var RE_UNICODE_ESCAPE = /\\u([a-fA-F0-9]{4})|\\U([a-fA-F0-9]{6})/y;
var RE_LEADING_NEWLINES = /^\n+/;
var RE_TRAILING_SPACES = / +$/;
var RE_BLANK_LINES = / *\r?\n/g;
var RE_INDENT = /( *)$/;
var TOKEN_BRACE_OPEN = /{\s*/y;
var TOKEN_BRACE_CLOSE = /\s*}/y;
var TOKEN_BRACKET_OPEN = /\[\s*/y;
var TOKEN_BRACKET_CLOSE = /\s*] */y;
var TOKEN_PAREN_OPEN = /\s*\(\s*/y;
var TOKEN_ARROW = /\s*->\s*/y;
var TOKEN_COLON = /\s*:\s*/y;
var TOKEN_COMMA = /\s*,?\s*/y;
var TOKEN_BLANK = /\s+/y;
var FluentResource = class {
	constructor(source) {
		this.body = [];
		RE_MESSAGE_START.lastIndex = 0;
		let cursor = 0;
		while (true) {
			let next = RE_MESSAGE_START.exec(source);
			if (next === null) break;
			cursor = RE_MESSAGE_START.lastIndex;
			try {
				this.body.push(parseMessage(next[1]));
			} catch (err) {
				if (err instanceof SyntaxError) continue;
				throw err;
			}
		}
		function test(re) {
			re.lastIndex = cursor;
			return re.test(source);
		}
		function consumeChar(char, errorClass) {
			if (source[cursor] === char) {
				cursor++;
				return true;
			}
			if (errorClass) throw new errorClass(`Expected ${char}`);
			return false;
		}
		function consumeToken(re, errorClass) {
			if (test(re)) {
				cursor = re.lastIndex;
				return true;
			}
			if (errorClass) throw new errorClass(`Expected ${re.toString()}`);
			return false;
		}
		function match(re) {
			re.lastIndex = cursor;
			let result = re.exec(source);
			if (result === null) throw new SyntaxError(`Expected ${re.toString()}`);
			cursor = re.lastIndex;
			return result;
		}
		function match1(re) {
			return match(re)[1];
		}
		function parseMessage(id) {
			let value = parsePattern();
			let attributes = parseAttributes();
			if (value === null && Object.keys(attributes).length === 0) throw new SyntaxError("Expected message value or attributes");
			return {
				id,
				value,
				attributes
			};
		}
		function parseAttributes() {
			let attrs = Object.create(null);
			while (test(RE_ATTRIBUTE_START)) {
				let name = match1(RE_ATTRIBUTE_START);
				let value = parsePattern();
				if (value === null) throw new SyntaxError("Expected attribute value");
				attrs[name] = value;
			}
			return attrs;
		}
		function parsePattern() {
			let first;
			if (test(RE_TEXT_RUN)) first = match1(RE_TEXT_RUN);
			if (source[cursor] === "{" || source[cursor] === "}") return parsePatternElements(first ? [first] : [], Infinity);
			let indent = parseIndent();
			if (indent) {
				if (first) return parsePatternElements([first, indent], indent.length);
				indent.value = trim(indent.value, RE_LEADING_NEWLINES);
				return parsePatternElements([indent], indent.length);
			}
			if (first) return trim(first, RE_TRAILING_SPACES);
			return null;
		}
		function parsePatternElements(elements = [], commonIndent) {
			while (true) {
				if (test(RE_TEXT_RUN)) {
					elements.push(match1(RE_TEXT_RUN));
					continue;
				}
				if (source[cursor] === "{") {
					elements.push(parsePlaceable());
					continue;
				}
				if (source[cursor] === "}") throw new SyntaxError("Unbalanced closing brace");
				let indent = parseIndent();
				if (indent) {
					elements.push(indent);
					commonIndent = Math.min(commonIndent, indent.length);
					continue;
				}
				break;
			}
			let lastIndex = elements.length - 1;
			let lastElement = elements[lastIndex];
			if (typeof lastElement === "string") elements[lastIndex] = trim(lastElement, RE_TRAILING_SPACES);
			let baked = [];
			for (let element of elements) {
				if (element instanceof Indent) element = element.value.slice(0, element.value.length - commonIndent);
				if (element) baked.push(element);
			}
			return baked;
		}
		function parsePlaceable() {
			consumeToken(TOKEN_BRACE_OPEN, SyntaxError);
			let selector = parseInlineExpression();
			if (consumeToken(TOKEN_BRACE_CLOSE)) return selector;
			if (consumeToken(TOKEN_ARROW)) {
				let variants = parseVariants();
				consumeToken(TOKEN_BRACE_CLOSE, SyntaxError);
				return {
					type: "select",
					selector,
					...variants
				};
			}
			throw new SyntaxError("Unclosed placeable");
		}
		function parseInlineExpression() {
			if (source[cursor] === "{") return parsePlaceable();
			if (test(RE_REFERENCE)) {
				let [, sigil, name, attr = null] = match(RE_REFERENCE);
				if (sigil === "$") return {
					type: "var",
					name
				};
				if (consumeToken(TOKEN_PAREN_OPEN)) {
					let args = parseArguments();
					if (sigil === "-") return {
						type: "term",
						name,
						attr,
						args
					};
					if (RE_FUNCTION_NAME.test(name)) return {
						type: "func",
						name,
						args
					};
					throw new SyntaxError("Function names must be all upper-case");
				}
				if (sigil === "-") return {
					type: "term",
					name,
					attr,
					args: []
				};
				return {
					type: "mesg",
					name,
					attr
				};
			}
			return parseLiteral();
		}
		function parseArguments() {
			let args = [];
			while (true) {
				switch (source[cursor]) {
					case ")":
						cursor++;
						return args;
					case void 0: throw new SyntaxError("Unclosed argument list");
				}
				args.push(parseArgument());
				consumeToken(TOKEN_COMMA);
			}
		}
		function parseArgument() {
			let expr = parseInlineExpression();
			if (expr.type !== "mesg") return expr;
			if (consumeToken(TOKEN_COLON)) return {
				type: "narg",
				name: expr.name,
				value: parseLiteral()
			};
			return expr;
		}
		function parseVariants() {
			let variants = [];
			let count = 0;
			let star;
			while (test(RE_VARIANT_START)) {
				if (consumeChar("*")) star = count;
				let key = parseVariantKey();
				let value = parsePattern();
				if (value === null) throw new SyntaxError("Expected variant value");
				variants[count++] = {
					key,
					value
				};
			}
			if (count === 0) return null;
			if (star === void 0) throw new SyntaxError("Expected default variant");
			return {
				variants,
				star
			};
		}
		function parseVariantKey() {
			consumeToken(TOKEN_BRACKET_OPEN, SyntaxError);
			let key;
			if (test(RE_NUMBER_LITERAL)) key = parseNumberLiteral();
			else key = {
				type: "str",
				value: match1(RE_IDENTIFIER)
			};
			consumeToken(TOKEN_BRACKET_CLOSE, SyntaxError);
			return key;
		}
		function parseLiteral() {
			if (test(RE_NUMBER_LITERAL)) return parseNumberLiteral();
			if (source[cursor] === "\"") return parseStringLiteral();
			throw new SyntaxError("Invalid expression");
		}
		function parseNumberLiteral() {
			let [, value, fraction = ""] = match(RE_NUMBER_LITERAL);
			let precision = fraction.length;
			return {
				type: "num",
				value: parseFloat(value),
				precision
			};
		}
		function parseStringLiteral() {
			consumeChar("\"", SyntaxError);
			let value = "";
			while (true) {
				value += match1(RE_STRING_RUN);
				if (source[cursor] === "\\") {
					value += parseEscapeSequence();
					continue;
				}
				if (consumeChar("\"")) return {
					type: "str",
					value
				};
				throw new SyntaxError("Unclosed string literal");
			}
		}
		function parseEscapeSequence() {
			if (test(RE_STRING_ESCAPE)) return match1(RE_STRING_ESCAPE);
			if (test(RE_UNICODE_ESCAPE)) {
				let [, codepoint4, codepoint6] = match(RE_UNICODE_ESCAPE);
				let codepoint = parseInt(codepoint4 || codepoint6, 16);
				return codepoint <= 55295 || 57344 <= codepoint ? String.fromCodePoint(codepoint) : "�";
			}
			throw new SyntaxError("Unknown escape sequence");
		}
		function parseIndent() {
			let start = cursor;
			consumeToken(TOKEN_BLANK);
			switch (source[cursor]) {
				case ".":
				case "[":
				case "*":
				case "}":
				case void 0: return false;
				case "{": return makeIndent(source.slice(start, cursor));
			}
			if (source[cursor - 1] === " ") return makeIndent(source.slice(start, cursor));
			return false;
		}
		function trim(text, re) {
			return text.replace(re, "");
		}
		function makeIndent(blank) {
			let value = blank.replace(RE_BLANK_LINES, "\n");
			let length = RE_INDENT.exec(blank)[1].length;
			return new Indent(value, length);
		}
	}
};
var Indent = class {
	constructor(value, length) {
		this.value = value;
		this.length = length;
	}
};
// www/shared/text/format.ts
function fixed(value, digits) {
	if (value == null || Number.isNaN(value)) return "–";
	if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
	const text = value.toFixed(digits);
	return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}
function decimalsOfError(error, otherwise) {
	return error != null && error > 0 && Number.isFinite(error) ? Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(error)))) : otherwise;
}
function count(value) {
	return value == null ? "–" : String(value).replace(/\B(?=(\d{3})+$)/gu, " ");
}
function grouped(text) {
	return text.replaceAll(/(?<![\p{L}\d_.,−-])\d{4,}(?![\p{L}\d_-]|[.,]\d|\.\p{L})/gu, (digits) => count(Number(digits)));
}
function withMinus(text) {
	return text.replaceAll(/(?<![\p{L}\p{N}_.,)−-])-(?=\d)/gu, "−");
}
function plain(value) {
	return String(value).replace("-", "−");
}
function significant(value) {
	if (value === 0) return "0";
	const size = Math.abs(value);
	if (size >= .001 && size < 1e5) return fixed(value, Math.max(0, 3 - Math.floor(Math.log10(size))));
	const [mantissa = "", exponent = ""] = value.toExponential(3).split("e");
	const power = [...exponent.replace("+", "")].map((c) => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(Number(c))).join("");
	return `${mantissa.replace("-", "−")}·10${power}`;
}
function percent(share) {
	return `${(100 * share).toFixed(1)} %`;
}
function sentence(text) {
	return `${text.replace(/\.$/u, "")}.`;
}
// www/shared/text/catalogue.ts
var Figure = class extends FluentNumber {
	toString() {
		return plain(this.value);
	}
};
var written = (write) => ([figure], { digits }) => figure instanceof FluentNumber ? write(figure.value, digits instanceof FluentNumber ? digits.value : 0) : "–";
var FUNCTIONS = {
	COUNT: written((value) => count(value)),
	FIXED: written(fixed)
};
var Catalogue = class {
	bundle;
	unread = new Map();
	constructor(language, isolating) {
		this.bundle = new FluentBundle(language, {
			useIsolating: isolating,
			functions: FUNCTIONS
		});
	}
	add(files) {
		for (const file of files) for (const entry of file.split(/\n(?=[a-z])/u)) this.unread.set(entry.slice(0, entry.indexOf(" ")), entry);
	}
	text(name, figures = {}, attribute = null) {
		this.read(name);
		const message = this.bundle.getMessage(name);
		const pattern = (attribute === null ? message?.value : message?.attributes[attribute]) ?? null;
		if (pattern === null) return null;
		return this.bundle.formatPattern(pattern, Object.fromEntries(Object.entries(figures).map(([key, value]) => [key, figureOf(value)])), []);
	}
	read(name) {
		const entry = this.unread.get(name);
		if (entry === void 0) return;
		this.unread.delete(name);
		this.bundle.addResource(new FluentResource(entry));
		for (const [, other = ""] of entry.matchAll(/\{ ([a-z][a-z0-9-]*) \}/gu)) this.read(other);
	}
};
function figureOf(value) {
	if (value === null || value === void 0) return "none";
	if (typeof value === "number") return Number.isFinite(value) ? new Figure(value) : "none";
	return String(value);
}
// www/shared/text/direction.ts
var IS_FROM_RIGHT = LANGUAGES[LANGUAGE].direction === "rtl";
var [LRI, RLI, PDI] = [
	"⁦",
	"⁧",
	"⁩"
];
var FSI = "⁨";
var ISOLATE = /[\u2066-\u2068]/u;
var LETTER = /\p{L}/u;
var FROM_RIGHT = /\p{Script=Arabic}/u;
var NUMBER = /\u2068([^\u2066-\u2069]+)\u2069(°?)/u.source;
var WITH_ERROR = new RegExp(`${NUMBER}([ \\u00a0]±[ \\u00a0])${NUMBER}`, "gu");
function asClauses(text, isFromRight = IS_FROM_RIGHT) {
	if (!isFromRight) return text;
	return ofParts(text.replaceAll(WITH_ERROR, `${LRI}$1$2$3$4$5${PDI}`).replaceAll(`${PDI}°`, `°${PDI}`).replaceAll(/\u2068(?=[\u2067\u2068]*[\s،؛,;:·(])/gu, RLI));
}
function ofParts(text) {
	const letters = [...text];
	const open = [];
	letters.forEach((letter, at) => {
		const part = open.at(-1);
		if (ISOLATE.test(letter)) open.push({
			at,
			isOwn: false,
			hasWords: false
		});
		else if (letter === PDI && part !== void 0) {
			open.pop();
			if (letters[part.at] === FSI && !part.isOwn && part.hasWords) letters[part.at] = RLI;
		} else if (part !== void 0 && LETTER.test(letter)) {
			part.isOwn = true;
			if (FROM_RIGHT.test(letter)) for (const around of open) around.hasWords = true;
		}
	});
	return letters.join("");
}
function asSentence(text) {
	return IS_FROM_RIGHT ? `${RLI}${text}${PDI}` : text;
}
function asFigure(text) {
	return IS_FROM_RIGHT ? `${LRI}${text}${PDI}` : text;
}
function withoutParts(text) {
	return text.replaceAll(/[\u2066-\u2069]/gu, "");
}
// www/shared/text/words.ts
var CATALOGUE = new Catalogue(LANGUAGE, LANGUAGE !== "en");
function learn(texts) {
	CATALOGUE.add(texts);
}
function say(name, figures = {}) {
	return asClauses(CATALOGUE.text(name, figures) ?? name);
}
function known(name, attribute = null) {
	return CATALOGUE.text(name, {}, attribute);
}
function refusedText(label) {
	return say("this-value-is-not-allowed", { label });
}
// www/shared/engine/platform.ts
var WORKER = {
	file: "worker.js",
	element: "tiepoint-worker"
};
var WASM = {
	file: "tiepoint_bg.wasm",
	element: "tiepoint-wasm"
};
function embedded(id) {
	return document.getElementById(id)?.textContent ?? null;
}
function besideFiles() {
	return embedded(WORKER.element) === null;
}
var workerUrl;
function spawnWorker(name) {
	const code = embedded(WORKER.element);
	workerUrl ??= code === null ? new URL(WORKER.file, document.baseURI).href : URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
	return new Worker(scriptAddress(workerUrl), {
		name: namedInLanguage(name),
		type: "classic"
	});
}
var compiled;
function wasmModule() {
	compiled ??= compileWasm().catch((error) => {
		compiled = void 0;
		throw error;
	});
	return compiled;
}
async function compileWasm() {
	const deflated = embedded(WASM.element);
	if (deflated !== null) return WebAssembly.compile(await inflated(deflated.trim()));
	const made = await compiledElsewhere(new URL(WASM.file, document.baseURI).href);
	if ("compiled" in made) return made.compiled;
	throw new Error(made.status === null ? made.message : say("the-program-file-could-not", {
		file: WASM.file,
		status: made.status
	}));
}
async function compiledElsewhere(compile) {
	const worker = spawnWorker("compile");
	try {
		return await new Promise((resolve, reject) => {
			worker.onmessage = ({ data }) => resolve(data);
			worker.onerror = (event) => {
				event.preventDefault();
				reject(new Error(event.message || say("the-worker-could-not-start")));
			};
			const first = { compile };
			worker.postMessage(first);
		});
	} finally {
		worker.terminate();
	}
}
function inflated(base64) {
	const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
	return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).arrayBuffer();
}
// www/shared/engine/parts.ts
async function loadPart(file, load) {
	if (besideFiles() && true) await reach(file);
	return load();
}
function fetchEarly(file) {
	if (!besideFiles() || false) return;
	const link = document.createElement("link");
	Object.assign(link, {
		rel: "modulepreload",
		href: new URL(file, document.baseURI).href
	});
	document.head.append(link);
}
async function reach(file) {
	const answer = await fetch(new URL(file, document.baseURI)).catch(() => null);
	if (answer?.ok !== true) throw new Error(say("the-file-of-the-page", {
		file,
		status: answer?.status ?? null
	}));
	await answer.arrayBuffer();
}
var LatePart = class {
	make;
	made = null;
	constructor(make) {
		this.make = make;
	}
	get() {
		this.made ??= this.make().catch((error) => {
			this.made = null;
			throw error;
		});
		return this.made;
	}
};
// \0vite/preload-helper.js
var __vitePreload = (load) => load();
// www/shared/engine/texts.ts
var FILES$1 = {
	en: {
		program: ["en.js", () => __vitePreload(() => import("./en.js"), [], import.meta.url)],
		block: ["en-block.js", () => __vitePreload(() => import("./en-block.js"), [], import.meta.url)]
	},
	ar: {
		program: ["ar.js", () => __vitePreload(() => import("./ar.js"), [], import.meta.url)],
		block: ["ar-block.js", () => __vitePreload(() => import("./ar-block.js"), [], import.meta.url)]
	}
};
var learned = [];
async function textsOf(language, part) {
	const { TEXTS } = await loadPart(...FILES$1[language][part]);
	return TEXTS;
}
async function learnPart(part) {
	const texts = await textsOf(LANGUAGE, part);
	if (learned.includes(part)) return;
	learned.push(part);
	learn(texts);
}
// www/shared/files/drop.ts
var FILES = "Files";
function mountDrop(tell) {
	let serving = null;
	const waiting = [];
	const take = (found) => {
		waiting.push(...found);
		tell(waiting.length);
	};
	const loading = {
		isActive: () => true,
		markAt: () => "page",
		take
	};
	const active = () => (serving ?? [loading]).find(({ isActive }) => isActive());
	const unmark = () => {
		delete document.body.dataset.drop;
	};
	document.addEventListener("dragover", (event) => {
		const taker = active();
		if (!hasFiles(event) || taker === void 0) return;
		event.preventDefault();
		document.body.dataset.drop = taker.markAt(event);
	});
	document.addEventListener("dragleave", (event) => {
		if (event.relatedTarget === null) unmark();
	});
	document.addEventListener("drop", (event) => {
		unmark();
		const taker = active();
		if (!hasFiles(event) || taker === void 0) return;
		event.preventDefault();
		const at = taker.markAt(event);
		const items = [...event.dataTransfer?.items ?? []].map((item) => ({
			entry: item.webkitGetAsEntry(),
			file: item.getAsFile()
		}));
		Promise.all(items.map(({ entry, file }) => found(entry, file))).then((lists) => {
			const late = taker === loading && serving !== null;
			(late ? active() : taker)?.take(lists.flat(), late ? null : at);
		});
	});
	document.addEventListener("paste", (event) => {
		const pasted = [...event.clipboardData?.files ?? []];
		const taker = active();
		if (pasted.length === 0 || taker === void 0) return;
		event.preventDefault();
		taker.take(pasted.map((file) => ({
			file,
			path: ""
		})), null);
	});
	return (takers) => {
		serving = takers;
		if (waiting.length > 0) active()?.take(waiting.splice(0), null);
	};
}
function hasFiles(event) {
	return event.dataTransfer?.types.includes(FILES) === true;
}
async function found(entry, file) {
	if (entry?.isDirectory !== true) return file === null ? [] : [{
		file,
		path: ""
	}];
	return below(entry);
}
async function below(folder) {
	return (await Promise.all((await entriesOf(folder)).map(async (entry) => {
		if (entry.isDirectory) return below(entry);
		const file = await new Promise((resolve) => entry.file(resolve, () => resolve(null)));
		return file === null ? [] : [{
			file,
			path: entry.fullPath.replace(/^\//u, "")
		}];
	}))).flat();
}
async function entriesOf(folder) {
	const reader = folder.createReader();
	const all = [];
	for (;;) {
		const portion = await new Promise((resolve) => reader.readEntries(resolve, () => resolve([])));
		if (portion.length === 0) return all;
		all.push(...portion);
	}
}
// www/shared/panel/dom.ts
function h(tag, attributes = {}, ...children) {
	const element = document.createElement(tag);
	for (const [name, value] of Object.entries(attributes)) setAttribute(element, name, value);
	element.append(...children.filter((child) => child !== null));
	return element;
}
function setAttribute(element, name, value) {
	if (value === void 0 || value === false) return;
	if (typeof value === "object") {
		for (const [aria, text] of Object.entries(value)) element.setAttribute(`aria-${aria}`, text);
		return;
	}
	element.setAttribute({
		testid: "data-testid",
		key: "data-key"
	}[name] ?? name, value === true ? "" : String(value));
}
function fill(element, ...children) {
	element.replaceChildren(...children.filter((child) => child !== null));
}
function arrange(element, ...children) {
	const wanted = new Set(children);
	for (const child of [...element.children]) if (!wanted.has(child)) child.remove();
	let next = element.firstElementChild;
	for (const child of children) if (child === next) next = next.nextElementSibling;
	else element.insertBefore(child, next);
}
function button(text, testid, onClick, title) {
	const made = h("button", {
		type: "button",
		testid,
		...title === void 0 ? {} : { title }
	}, text);
	made.addEventListener("click", onClick);
	return made;
}
var SVG = "http://www.w3.org/2000/svg";
function svg(tag, attributes, ...children) {
	const element = document.createElementNS(SVG, tag);
	for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
	element.append(...children.filter((child) => child !== null));
	return element;
}
function byId(id) {
	const element = document.getElementById(id);
	if (element === null) throw new Error(`the page has no element "${id}"`);
	return element;
}
function section(title, testid, ...children) {
	const id = `h-${testid}`;
	return h("section", {
		class: "section",
		testid,
		aria: { labelledby: id }
	}, h("h3", { id }, title), ...children);
}
function markStale(element, stale) {
	if (stale) {
		element.classList.add("is-earlier");
		element.querySelector("th, figcaption")?.append(h("span", { class: "earlier" }, say("earlier-settings-2")));
	}
	return element;
}
function row(heading, ...cells) {
	return h("tr", {}, h("th", { scope: "row" }, heading), ...cells.map((cell) => cell instanceof HTMLTableCellElement ? cell : h("td", {}, cell)));
}
// www/shared/panel/language.ts
var ATTRIBUTES = [
	"title",
	"aria-label",
	"aria-roledescription",
	"content"
];
function sayDocument() {
	document.documentElement.style.setProperty("--earlier-settings", JSON.stringify(say("earlier-settings-2")));
	if (LANGUAGE === "en") return;
	for (const element of document.querySelectorAll("[data-say]")) fill(element, ...withKeys(say(element.dataset.say ?? "")));
	for (const attribute of ATTRIBUTES) {
		const name = `data-say-${attribute.replace("aria-", "")}`;
		for (const element of document.querySelectorAll(`[${name}]`)) element.setAttribute(attribute, say(element.getAttribute(name) ?? ""));
	}
	showDocument();
}
function showDocument() {
	delete document.documentElement.dataset.unsaid;
}
function withKeys(text) {
	return text.split(/\[([^\]]+)\]/u).map((part, i) => i % 2 === 0 ? part : h("kbd", {}, part));
}
function mountLanguage(press, keeper) {
	const other = LANGUAGE === "en" ? "ar" : "en";
	const name = h("span", {}, LANGUAGES[other].name);
	name.lang = other;
	fill(press, name);
	press.addEventListener("click", () => void change(other, keeper()));
}
async function change(to, keeper) {
	await keeper?.flush();
	if (keeper?.isLost === true && !window.confirm(say("the-last-changes-on-the"))) return;
	keepLanguage(to);
	location.reload();
}
// www/main.ts
var LONGEST_WAIT_MS = 1e3;
function firstView() {
	return new Promise((drawn) => {
		if (document.hidden) drawn();
		else {
			requestAnimationFrame(() => window.setTimeout(drawn));
			window.setTimeout(drawn, LONGEST_WAIT_MS);
		}
	});
}
async function start() {
	const answer = document.getElementById("status");
	let [given, hasTexts] = [0, false];
	const tell = () => {
		const hasFailed = document.getElementById("answer")?.dataset.kind === "problem";
		if (hasTexts && !hasFailed && given > 0) answer?.replaceChildren(say("loading-the-program-files", { files: given }));
	};
	const serveDrop = mountDrop((waiting) => {
		given = waiting;
		tell();
	});
	await firstView();
	fetchEarly("program.js");
	wasmModule().catch(() => void 0);
	await learnPart("program");
	sayDocument();
	hasTexts = true;
	tell();
	const { startProgram } = await __vitePreload(async () => {
		const { startProgram } = await import("./program.js");
		return { startProgram };
	}, [], import.meta.url);
	await startProgram(serveDrop);
}
document.getElementById("load-again")?.addEventListener("click", () => location.reload());
start().catch(() => {
	document.getElementById("status")?.replaceChildren();
	document.getElementById("not-loaded")?.removeAttribute("hidden");
	showDocument();
});
export { LANGUAGE, LANGUAGES, LatePart, __vitePreload, arrange, asClauses, asFigure, asSentence, besideFiles, button, byId, count, decimalsOfError, fill, fixed, grouped, h, keepChoice, keptChoice, known, learnPart, loadPart, markStale, mountLanguage, percent, refusedText, row, say, scriptAddress, section, sentence, significant, spawnWorker, svg, wasmModule, withMinus, withoutParts };
