/** The PostgreSQL that the server runs itself when it is given none. */
@NullMarked
package org.dronemap.store.postgres.own;

import org.jspecify.annotations.NullMarked;
