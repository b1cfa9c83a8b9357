package org.dronemap.core.stored;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Fixes the names under which a record or an enum is stored, whatever its name in the code. The code may be renamed;
 * these words stay for ever, or what earlier versions have stored cannot be read any more.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface Stored {
    /** Of a record that is one of several: the word that tells it from the others. */
    String as() default "";

    /** Of the components of a record, or the constants of an enum, in the order of the code, apart by a space. */
    String names() default "";

    /**
     * Those of its components that earlier versions had not, as {@link #names} has them: left out while they are null or empty,
     * so that what was written without them is written as it was.
     */
    String later() default "";
}
