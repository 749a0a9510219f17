package org.jsmesh.desktop;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads {@code 1024x768}. */
final class SizeConverter implements ITypeConverter<PictureSize> {
    /** What every graphics card since OpenGL 4 draws in one piece. */
    private static final int MOST = 8192;

    @Override
    public PictureSize convert(String text) {
        Matcher m = Pattern.compile("(\\d{1,5})[x×](\\d{1,5})").matcher(text);
        if (!m.matches()) throw new TypeConversionException("'" + text + "' is no size; write for example 1024x768");
        int width = Integer.parseInt(m.group(1));
        int height = Integer.parseInt(m.group(2));
        if (Math.min(width, height) < 1 || Math.max(width, height) > MOST) {
            throw new TypeConversionException("'" + text + "' is not between 1x1 and " + MOST + "x" + MOST);
        }
        return new PictureSize(width, height);
    }
}
