/**
 * Who asks: users, roles, access keys and the ports that keep them.
 *
 * <p>Enters: a word about who may do what.
 *
 * <p>Never: how somebody proves who he is.
 */
@NullMarked
package org.dronemap.core.access;

import org.jspecify.annotations.NullMarked;
