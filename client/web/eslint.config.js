// Rules for the viewer, its tests and the benchmark scripts; to be run from the top of the repository.

import js from '@eslint/js';
import globals from 'globals';

const viewer = 'client/web/src/main/js/**/*.js';
const tests = 'client/web/src/test/js/**/*.js';
const scripts = 'server/app/src/bench/*.mjs';
const benchPage = 'server/app/src/bench/*.js';
const own = 'client/web/*.js';

export default [
  { ignores: ['**/node_modules/', '**/target/'] },
  { files: [viewer, tests, scripts, benchPage, own], ...js.configs.recommended },
  {
    files: [viewer, tests, scripts, benchPage, own],
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    languageOptions: { ecmaVersion: 2022, sourceType: 'module' },
    rules: {
      'array-callback-return': 'error',
      'class-methods-use-this': ['error', { enforceForClassFields: false }],
      curly: ['error', 'multi-line'],
      'default-case-last': 'error',
      eqeqeq: 'error',
      'guard-for-in': 'error',
      'max-lines': ['error', 300],
      'no-constructor-return': 'error',
      'no-duplicate-imports': 'error',
      'no-eval': 'error',
      'no-extend-native': 'error',
      'no-implicit-coercion': ['error', { boolean: false }],
      'no-implicit-globals': 'error',
      'no-implied-eval': 'error',
      'no-new-func': 'error',
      'no-new-wrappers': 'error',
      'no-self-compare': 'error',
      'no-sequences': 'error',
      'no-shadow': 'error',
      'no-template-curly-in-string': 'error',
      'no-throw-literal': 'error',
      'no-unreachable-loop': 'error',
      'no-unused-expressions': 'error',
      'no-unused-vars': ['error', { ignoreRestSiblings: true }],
      'no-use-before-define': ['error', { functions: false, classes: false, variables: false }],
      'no-useless-return': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': 'error',
      'prefer-promise-reject-errors': 'error',
      radix: 'error',
    },
  },
  { files: [viewer, benchPage], languageOptions: { globals: globals.browser } },
  { files: [tests, scripts, own], languageOptions: { globals: globals.node } },
  // Stand-ins have the methods of what they stand for.
  { files: [tests], languageOptions: { globals: { indexedDB: 'readonly' } }, rules: { 'class-methods-use-this': 'off' } },
];
