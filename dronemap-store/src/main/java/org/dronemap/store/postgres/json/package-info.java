/**
 * JSON of columns that hold what has no table of its own.
 *
 * <p>Enters: the form of one such value.
 *
 * <p>Never: SQL.
 */
@NullMarked
package org.dronemap.store.postgres.json;

import org.jspecify.annotations.NullMarked;
