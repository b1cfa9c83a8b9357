/** PostgreSQL adapters of the store ports, their schema, backup and restore. */
@NullMarked
package org.dronemap.store.postgres;

import org.jspecify.annotations.NullMarked;
