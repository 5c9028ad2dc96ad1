"""Wire types of the REST API; the browser's TypeScript types are generated from them."""
