// schemas/openapi.json is OpenAPI 3.1, and names in it mean what they should:
//   node openapi_lint.mjs ../../schemas/openapi.json
// Ends with 77, which CTest counts as skipped, where the validator is not installed (npm ci here).
import fs from 'node:fs';

const kMethods = ['get', 'put', 'post', 'delete', 'patch', 'head', 'options'];
let Validator;
try {
  ({ Validator } = await import('@seriousme/openapi-schema-validator'));
} catch {
  console.log("skipped: the validator is not installed; 'npm ci' in tests/service");
  process.exit(77);
}

const text = fs.readFileSync(process.argv[2], 'utf8');
const read = () => JSON.parse(text);

// What the published schema of OpenAPI 3.1 finds wrong.
const schemaFaults = async (api) => {
  const validator = new Validator();
  const { valid, errors } = await validator.validate(api);
  if (valid && validator.version !== '3.1') return [`is OpenAPI ${validator.version}`];
  return valid ? [] : [].concat(errors).map((error) => JSON.stringify(error));
};

const at = (api, ref) => ref.slice(2).split('/').reduce((node, name) => node?.[name.replaceAll('~1', '/').replaceAll('~0', '~')], api);

// All others look into the store, if only for the caller's key.
const kWithoutStore = ['/healthz', '/version', '/openapi.json'];

const operationsOf = (api) => Object.entries(api.paths).flatMap(([path, item]) =>
  kMethods.filter((method) => item[method]).map((method) => ({ path, method, ...item[method] })));

// What no schema can say: references lead somewhere, all that stands under components is referred
// to, ids are each one's own, and a path's parameters are those in its braces.
const nameFaults = (api) => {
  const faults = [];
  const referred = new Set();
  const visit = (node) => {
    if (node === null || typeof node !== 'object') return;
    if (typeof node.$ref === 'string') {
      referred.add(node.$ref);
      if (!node.$ref.startsWith('#/') || at(api, node.$ref) === undefined) faults.push(`${node.$ref} leads nowhere`);
    }
    Object.values(node).forEach(visit);
  };
  visit(api);
  for (const kind of ['schemas', 'responses', 'parameters', 'headers']) {
    for (const name of Object.keys(api.components[kind] ?? {})) {
      if (!referred.has(`#/components/${kind}/${name}`)) faults.push(`components/${kind}/${name} is used nowhere`);
    }
  }
  const tags = new Set((api.tags ?? []).map(({ name }) => name));
  const ids = new Set();
  for (const { path, method, operationId, summary, tags: own = [], parameters = [], responses } of operationsOf(api)) {
    const where = `${method.toUpperCase()} ${path}`;
    if (!operationId || ids.has(operationId)) faults.push(`${where}: the operationId ${operationId} is missing or another's`);
    ids.add(operationId);
    if (!summary) faults.push(`${where} has no summary`);
    for (const tag of own) if (!tags.has(tag)) faults.push(`${where}: nothing describes the tag ${tag}`);
    const inPath = parameters.map((one) => (one.$ref ? at(api, one.$ref) : one)).filter((one) => one.in === 'path').map(({ name }) => name);
    const inBraces = [...path.matchAll(/\{([^}]+)\}/g)].map(([, name]) => name);
    if (inPath.sort().join() !== inBraces.sort().join()) faults.push(`${where} describes the parameters ${inPath}, not ${inBraces}`);
    if (!Object.keys(responses).some((status) => /^[23]/.test(status))) faults.push(`${where} describes no success`);
    if (!kWithoutStore.includes(path) && !responses['503']) faults.push(`${where} does not say what it answers while the store is away`);
  }
  return faults;
};

// A lint that finds nothing in a broken description would find nothing in ours.
const kBroken = [
  ['no title', schemaFaults, (api) => { delete api.info.title; }],
  ['a response without description', schemaFaults, (api) => { delete api.paths['/healthz'].get.responses['200'].description; }],
  ['a parameter nowhere', schemaFaults, (api) => { api.paths['/v1/jobs'].get.parameters[0].in = 'nowhere'; }],
  ['a member nobody knows', schemaFaults, (api) => { api.paths['/healthz'].get.answers = {}; }],
  ['a reference to nothing', nameFaults, (api) => { api.paths['/v1/jobs'].get.responses['400'] = { $ref: '#/components/responses/None' }; }],
  ['two of one id', nameFaults, (api) => { api.paths['/healthz'].get.operationId = 'listJobs'; }],
  ['no answer while the store is away', nameFaults, (api) => { delete api.paths['/v1/jobs'].get.responses['503']; }],
  ['a path without its parameter', nameFaults, (api) => { api.paths['/v1/jobs/{id}'].get.parameters = []; }],
];
let failed = false;
for (const [what, faultsOf, breaking] of kBroken) {
  const api = read();
  breaking(api);
  if ((await faultsOf(api)).length > 0) continue;
  failed = true;
  console.log(`FAILED: finds nothing wrong in ${what}`);
}
const faults = [...await schemaFaults(read()), ...nameFaults(read())];
for (const fault of faults) console.log(`FAILED: ${fault}`);
if (!failed && faults.length === 0) console.log(`${operationsOf(read()).length} operations described as OpenAPI 3.1 has it`);
process.exit(failed || faults.length > 0 ? 1 : 0);
