/** Who asks: users, roles, access keys and the ports that keep them. */
@NullMarked
package org.dronemap.core.access;

import org.jspecify.annotations.NullMarked;
