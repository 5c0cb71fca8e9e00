/** How pictures are shown: shares of their own brightness and contrast. Nothing is computed from the picture that this makes. */
export interface Light {
  brightness: number;
  contrast: number;
}

/** As the files have them. */
export const OWN_LIGHT: Light = { brightness: 1, contrast: 1 };

export const isOwnLight = ({ brightness, contrast }: Light): boolean => brightness === OWN_LIGHT.brightness && contrast === OWN_LIGHT.contrast;
