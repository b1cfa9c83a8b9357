/**
 * The PostgreSQL that the server runs itself when it is given none.
 *
 * <p>Enters: what installs, starts and stops it.
 *
 * <p>Never: tables.
 */
@NullMarked
package org.dronemap.store.postgres.bundled;

import org.jspecify.annotations.NullMarked;
