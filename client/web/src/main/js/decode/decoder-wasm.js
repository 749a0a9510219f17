// @ts-check
// Loads the decoder that TeaVM compiled to WebAssembly GC. TeaVM's own loader builds its glue with `new Function`, which a strict
// Content-Security-Policy forbids; the decoder needs only the part of the glue below, which is plain functions.

const BUILTINS = 'wasm:js-string';
const PAGE_SHIFT = 16;
const MAX_MEMORY = 0x7fffffff;

/** @typedef {any} Value of Java or JavaScript, whose type the decoder alone knows */
/** @typedef {(...args: Value[]) => Value} Method */
/** @typedef {Record<string, any>} Glue functions and globals by name */

/**
 * Starts a module; resolves to the exported methods.
 *
 * @param {URL | WebAssembly.Module} source where to fetch it, or the module, compiled elsewhere with the same options
 * @param {Record<string, Glue>} more what a larger module than the decoder imports
 */
export async function loadWebAssembly(source, more = {}) {
  const module = source instanceof WebAssembly.Module ? source : await compile(source);
  const missing = WebAssembly.Module.imports(module).filter((i) => i.module === BUILTINS);
  if (missing.length > 0) throw new Error('this browser lacks the string functions of WebAssembly');
  /** @type {Record<string, Method>} */
  const exports = {};
  /** @type {WebAssembly.Instance | null} */
  let instance = null;
  const wrap = (/** @type {Value} */ value) => /** @type {any} */ (instance).exports['teavm.jso.createWrapper'](value);
  const glue = { ...glueOf(module, wrap), ...more };
  for (const { module: part, name } of WebAssembly.Module.imports(module)) {
    if (glue[part]?.[name] === undefined) throw new Error(`the decoder asks for ${part}.${name}, which its loader lacks`);
  }
  instance = await WebAssembly.instantiate(module, glue);
  for (const [name, value] of Object.entries(instance.exports)) {
    // A method of the main class is exported as a global that holds the function.
    if (value instanceof WebAssembly.Global) Object.defineProperty(exports, name, { get: () => value.value });
  }
  return exports;
}

/**
 * @param {URL} url
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compile(url) {
  const options = { builtins: ['js-string'] };
  /** @type {any} TypeScript does not know the options yet. */
  const wasm = WebAssembly;
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  return wasm.compile(await response.arrayBuffer(), options);
}

/**
 * All that the module imports but the browser's own functions of strings, and nothing else.
 *
 * @param {WebAssembly.Module} module
 * @param {Method} wrap makes a Java object of one of JavaScript
 * @returns {Record<string, Glue>}
 */
export function glueOf(module, wrap) {
  return {
    ...memoryGlue(module),
    // Exceptions stay inside the decoder, so they need no stack.
    teavm: { takeStackTrace: () => ({ getStack: () => [] }), decorateException() {} },
    teavmDate: { currentTimeMillis: () => Date.now() },
    teavmMath: { floor: Math.floor, random: Math.random, sqrt: Math.sqrt },
    teavmJso: objectGlue(wrap),
  };
}

/**
 * @param {WebAssembly.Module} module
 * @returns {Record<string, Glue>}
 */
function memoryGlue(module) {
  const sections = WebAssembly.Module.customSections(module, 'teavm.memoryRequirements');
  const needs = sections.length === 1 ? JSON.parse(new TextDecoder().decode(sections[0])) : {};
  const heapOffset = ((needs.dataSize ?? 0) + 7) & ~7;
  const initial = Math.max(needs.min ?? 0, 1);
  const memory = new WebAssembly.Memory({ initial, maximum: ((MAX_MEMORY - 1) >> PAGE_SHIFT) + 1 });
  return {
    env: { memory },
    teavmMemory: {
      linearMemory: () => memory.buffer,
      notifyHeapResized() {},
      heapOffset: new WebAssembly.Global({ value: 'i32', mutable: false }, heapOffset),
      maxSize: new WebAssembly.Global({ value: 'i32', mutable: false }, MAX_MEMORY),
    },
  };
}

/**
 * What TeaVM calls to see JavaScript's objects and to export its methods.
 *
 * @param {Method} wrap makes a Java object of one of JavaScript
 * @returns {Glue}
 */
function objectGlue(wrap) {
  /** @type {Method} */
  const same = (value) => value;
  const javaObject = Symbol('javaObject');
  const wrappers = new WeakMap();
  /** @type {(method: Method) => Method} a function of JavaScript for one of Java */
  const calling = (method) => (...args) => method(...args);
  /** @type {Method} */
  const resolve = (name) => /** @type {any} */ (globalThis)[name];
  /** @type {Method} */
  const callFunction = (method, ...args) => method(...args);
  /** @type {Method} */
  const callMethod = (object, name, ...args) => (object === null ? resolve(name)(...args) : object[name](...args));
  /** @type {Method} */
  const construct = (type, ...args) => new type(...args);
  return {
    stringBuiltinsSupported: () => 1,
    isUndefined: (/** @type {Value} */ value) => (value === undefined ? 1 : 0),
    unwrapBoolean: (/** @type {Value} */ value) => (value ? 1 : 0),
    unwrapByte: same,
    unwrapInt: same,
    unwrapDouble: same,
    wrapShort: same,
    wrapInt: same,
    getProperty: (/** @type {Value} */ object, /** @type {string} */ name) => (object === null ? resolve(name) : object[name]),
    setProperty(/** @type {Value} */ object, /** @type {string} */ name, /** @type {Value} */ value) {
      object[name] = value;
    },
    global: resolve,
    instanceOf: (/** @type {Value} */ value, /** @type {Value} */ type) => value instanceof type,
    createClass: () => class {},
    defineFunction: calling,
    defineMethod() {},
    defineStaticMethod(/** @type {Value} */ type, /** @type {string} */ name, /** @type {Method} */ method) {
      type[name] = calling(method);
    },
    javaObjectToJS: (/** @type {Value} */ instance, /** @type {Value} */ type) =>
      instance === null ? null : Object.assign(new type(), { [javaObject]: instance }),
    unwrapJavaObject: (/** @type {Value} */ object) => object[javaObject],
    asFunction: (/** @type {Value} */ object, /** @type {string} */ name) =>
      object === null || object === undefined ? null : calling((/** @type {Value[]} */ ...args) => object[name](...args)),
    wrapObject(/** @type {Value} */ object) {
      if (object === null) return null;
      if (typeof object !== 'object' && typeof object !== 'function') return wrap(object);
      const known = object[javaObject] ?? wrappers.get(object);
      if (known !== undefined) return known;
      const wrapper = wrap(object);
      wrappers.set(object, wrapper);
      return wrapper;
    },
    createFunction0: createFunction,
    createFunction1: createFunction,
    callFunction0: callFunction,
    callFunction1: callFunction,
    callMethod0: callMethod,
    callMethod3: callMethod,
    construct1: construct,
    construct3: construct,
  };
}

/**
 * The script fragments of TeaVM's class library that the decoder reaches; they come as text.
 *
 * @param {string[]} parts names of the parameters, then the body
 * @returns {Method}
 */
function createFunction(...parts) {
  const body = parts.pop() ?? '';
  const named = /^\s*return (\w+);\s*$/.exec(body);
  const index = named ? parts.indexOf(named[1]) : -1;
  if (index >= 0) return (...args) => args[index];
  if (/^\s*\{\s*return \{\};\s*\}\s*$/.test(body)) return () => ({});
  throw new Error(`the decoder's loader lacks the function "${body}"`);
}
