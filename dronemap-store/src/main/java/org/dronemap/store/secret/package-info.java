/**
 * What must not lie readable in a database: sealed with a secret of this server.
 *
 * <p>Enters: what seals or opens a secret.
 *
 * <p>Never: who may read it.
 */
@NullMarked
package org.dronemap.store.secret;

import org.jspecify.annotations.NullMarked;
