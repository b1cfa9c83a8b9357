/** PostgreSQL adapters of the store ports, and the server's own PostgreSQL. */
@NullMarked
package org.dronemap.store.postgres;

import org.jspecify.annotations.NullMarked;
