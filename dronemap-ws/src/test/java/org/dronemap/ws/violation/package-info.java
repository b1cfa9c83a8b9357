/** What the rules of the house forbid, planted to see that they find it. */
@NullMarked
package org.dronemap.ws.violation;

import org.jspecify.annotations.NullMarked;
