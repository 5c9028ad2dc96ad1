"""Files of other systems: each module reads (and where needed writes) one format. Files are untrusted."""
