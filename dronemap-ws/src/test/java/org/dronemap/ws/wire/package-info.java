/** What callers see, compared with what the tree says that they see. */
@NullMarked
package org.dronemap.ws.wire;

import org.jspecify.annotations.NullMarked;
