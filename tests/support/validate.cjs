// SPDX-License-Identifier: MIT
// Prints the codes of the errors that the Khronos validator finds in each file, as JSON:
//   node validate.cjs FOLDER_OF_NODE_MODULES FILE...
const fs = require('fs');
const path = require('path');
const [modules, ...files] = process.argv.slice(2);
const validator = require(path.join(modules, 'gltf-validator'));

async function errorCodes(file) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
        uri: path.basename(file),
        maxIssues: 1000,
        externalResourceFunction: async (uri) => new Uint8Array(
            fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))),
    });
    return report.issues.messages.filter((message) => message.severity === 0)
        .map((message) => `${message.code} ${message.pointer}`);
}

(async () => {
    const result = {};
    for (const file of files) result[file] = await errorCodes(file);
    console.log(JSON.stringify(result));
})();
