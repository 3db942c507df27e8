// Prints what Khronos' glTF-Validator says of a file, as JSON.
const fs = require('fs');
const validator = require('gltf-validator');

validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2]))).then((report) => {
  console.log(JSON.stringify({ issues: report.issues, info: report.info }));
});
