@NullMarked
package org.dronemap.proxy;

import org.jspecify.annotations.NullMarked;
