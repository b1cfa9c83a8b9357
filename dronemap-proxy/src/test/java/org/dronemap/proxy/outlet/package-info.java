@NullMarked
package org.dronemap.proxy.outlet;

import org.jspecify.annotations.NullMarked;
