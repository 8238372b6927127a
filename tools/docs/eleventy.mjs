// What Eleventy takes from a file alone; the rest of its configuration is in build.mjs.
export default () => ({ markdownTemplateEngine: 'njk', htmlTemplateEngine: false });
