package org.dronemap.proxy.outlet.rights;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * An IP address or a small network, such as {@code 192.0.2.0/24}, from which a personal outlet port may be used.
 * Immutable.
 */
public final class AddressRange {
    /** How it is written. */
    public static final String FORM =
            "an IP address, or a network: at most a /24, of IPv6 a /64 (192.0.2.0/24, 2001:db8::/64)";

    private static final Pattern TEXT = Pattern.compile("([0-9a-fA-F:.]{2,45})(?:/(\\d{1,3}))?");
    private static final Pattern VERSION_4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");
    private static final int WIDEST_4 = 24;
    private static final int WIDEST_6 = 64;
    private static final int LENGTH_4 = 4;

    private final byte[] base;
    private final int prefix;

    private AddressRange(byte[] base, int prefix) {
        this.base = base;
        this.prefix = prefix;
    }

    /**
     * Reads one.
     *
     * @throws IllegalArgumentException with a sentence for anything else, and for wider networks
     */
    public static AddressRange parse(String text) {
        Matcher matcher = TEXT.matcher(text.strip());
        if (!matcher.matches()) {
            throw new IllegalArgumentException("Write " + FORM + ".");
        }
        byte[] address = bytes(matcher.group(1));
        String given = matcher.group(2);
        int longest = address.length * Byte.SIZE;
        int prefix = given == null ? longest : Integer.parseInt(given);
        if (prefix > longest || prefix < (address.length == LENGTH_4 ? WIDEST_4 : WIDEST_6)) {
            throw new IllegalArgumentException("Write " + FORM + ".");
        }
        byte[] base = masked(address, prefix);
        if (everybody(base)) {
            throw new IllegalArgumentException("Write " + FORM + "; " + text + " is nobody's.");
        }
        return new AddressRange(base, prefix);
    }

    private static boolean everybody(byte[] base) {
        return Arrays.equals(base, new byte[base.length]);
    }

    private static byte[] bytes(String address) {
        boolean form4 = VERSION_4.matcher(address).matches();
        try {
            if (form4 || address.indexOf(':') >= 0) {
                return InetAddress.getByName(address).getAddress();
            }
        } catch (UnknownHostException notNumbers) {
            throw new IllegalArgumentException("Write " + FORM + ".", notNumbers);
        }
        throw new IllegalArgumentException("Write " + FORM + ".");
    }

    private static byte[] masked(byte[] address, int prefix) {
        byte[] masked = new byte[address.length];
        for (int bit = 0; bit < prefix; bit++) {
            masked[bit / Byte.SIZE] |= (byte) (address[bit / Byte.SIZE] & 0x80 >>> bit % Byte.SIZE);
        }
        return masked;
    }

    /** {@code host} is numeric, as peers are known by; on which interface it is does not matter. */
    public boolean contains(String host) {
        byte[] address = bytes(host.split("%", 2)[0]);
        return address.length == base.length && Arrays.equals(masked(address, prefix), base);
    }

    @Override
    public String toString() {
        try {
            String host = InetAddress.getByAddress(base).getHostAddress();
            return prefix == base.length * Byte.SIZE ? host : host + "/" + prefix;
        } catch (UnknownHostException wrongLength) {
            throw new IllegalStateException(wrongLength);
        }
    }
}
