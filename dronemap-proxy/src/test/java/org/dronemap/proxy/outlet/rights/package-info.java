@NullMarked
package org.dronemap.proxy.outlet.rights;

import org.jspecify.annotations.NullMarked;
