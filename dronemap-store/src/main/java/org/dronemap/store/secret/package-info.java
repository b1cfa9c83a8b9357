/** What must not lie readable in a database: sealed with a secret of this server. */
@NullMarked
package org.dronemap.store.secret;

import org.jspecify.annotations.NullMarked;
