/**
 * PostgreSQL adapters of the store ports, their schema, backup and restore.
 *
 * <p>Enters: an adapter of a port, with its tables.
 *
 * <p>Never: decisions.
 */
@NullMarked
package org.dronemap.store.postgres;

import org.jspecify.annotations.NullMarked;
